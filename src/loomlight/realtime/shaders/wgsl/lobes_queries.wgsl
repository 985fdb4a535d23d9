@binding(1) @group(1) var<storage, read> query_count_0 : array<u32>;

struct Query_std430_0
{
    @align(4) fabric_0 : u32,
    @align(4) centre_x_0 : f32,
    @align(4) centre_y_0 : f32,
    @align(4) dx_x_0 : f32,
    @align(4) dx_y_0 : f32,
    @align(4) dy_x_0 : f32,
    @align(4) dy_y_0 : f32,
    @align(4) light_x_0 : f32,
    @align(4) light_y_0 : f32,
    @align(4) light_z_0 : f32,
    @align(4) view_x_0 : f32,
    @align(4) view_y_0 : f32,
    @align(4) view_z_0 : f32,
};

@binding(0) @group(1) var<storage, read> queries_0 : array<Query_std430_0>;

@binding(2) @group(1) var<storage, read_write> answers_0 : array<vec4<f32>>;

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

struct Woven_std430_0
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
    @align(4) width_0 : f32,
    @align(4) height_0 : f32,
    @align(4) is_trilinear_0 : u32,
};

struct Fabric_std430_0
{
    @align(4) warp_0 : u32,
    @align(4) weft_0 : u32,
    @align(4) lobes_0 : Lobes_std430_0,
    @align(4) woven_0 : Woven_std430_0,
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
    @align(4) uv_width_0 : f32,
    @align(4) uv_height_0 : f32,
    @align(4) is_open_0 : u32,
    @align(4) openness_0 : u32,
    @align(4) albedo_map_0 : u32,
    @align(4) albedo_map_levels_0 : u32,
    @align(4) has_yarns_0 : u32,
    @align(4) mean_hole_0 : f32,
    @align(4) latent_0 : Latent_std430_0,
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
};

@binding(1) @group(0) var<storage, read> families_0 : array<Family_std430_0>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

var<private> TAP_OFFSETS_0 : array<vec2<f32>, i32(9)> = array<vec2<f32>, i32(9)>( vec2<f32>(-0.3333333432674408f, -0.3333333432674408f), vec2<f32>(-0.3333333432674408f, 0.0f), vec2<f32>(-0.3333333432674408f, 0.3333333432674408f), vec2<f32>(0.0f, -0.3333333432674408f), vec2<f32>(0.0f, 0.0f), vec2<f32>(0.0f, 0.3333333432674408f), vec2<f32>(0.3333333432674408f, -0.3333333432674408f), vec2<f32>(0.3333333432674408f, 0.0f), vec2<f32>(0.3333333432674408f, 0.3333333432674408f) );
var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
var<private> POINT_OFFSETS_0 : array<vec2<f32>, i32(8)> = array<vec2<f32>, i32(8)>( vec2<f32>(0.0f, 0.0f), vec2<f32>(-0.23010000586509705f, 0.35670000314712524f), vec2<f32>(0.36809998750686646f, -0.22939999401569366f), vec2<f32>(-0.28040000796318054f, -0.34400001168251038f), vec2<f32>(0.3465999960899353f, 0.28859999775886536f), vec2<f32>(-0.36349999904632568f, 0.0511000007390976f), vec2<f32>(0.09929999709129333f, -0.35699999332427979f), vec2<f32>(0.10710000246763229f, 0.32879999279975891f) );
struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S1 : vec2<f32> = this_0.dx_0;
    var _S2 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S1, _S1) + dot(_S2, _S2)));
}

fn natural_logarithm_0( x_1 : f32) -> f32
{
    var _S3 : u32 = (bitcast<u32>((x_1)));
    var exponent_0 : f32 = f32(i32((_S3 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S3 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S4 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S4 - exponent_1 * 0.00021219444170129f - 0.5f * _S4) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_2 : f32) -> f32
{
    return natural_logarithm_0(x_2) * 1.4426950216293335f;
}

fn to_face_frame_0( direction_0 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S5 : vec2<f32> = direction_0.xy;
    var _S6 : f32;
    if(back_2)
    {
        _S6 = - direction_0.z;
    }
    else
    {
        _S6 = direction_0.z;
    }
    return vec3<f32>(_S5, _S6);
}

struct SurfacePoint_0
{
     hole_0 : bool,
     is_warp_0 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_1 : f32,
     normal_0 : vec3<f32>,
     tangent_0 : vec3<f32>,
     across_0 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_2 : f32,  normal_1 : vec3<f32>,  tangent_1 : vec3<f32>,  across_1 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32) -> SurfacePoint_0
{
    var _S7 : SurfacePoint_0;
    _S7.hole_0 = hole_1;
    _S7.is_warp_0 = is_warp_1;
    _S7.warp_thread_0 = warp_thread_1;
    _S7.weft_thread_0 = weft_thread_1;
    _S7.height_1 = height_2;
    _S7.normal_0 = normal_1;
    _S7.tangent_0 = tangent_1;
    _S7.across_0 = across_1;
    _S7.fibre_across_0 = fibre_across_1;
    _S7.fibre_along_0 = fibre_along_1;
    return _S7;
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
    var _S8 : Blocked_0 = no_blocked_0();
    nothing_2.warp_1 = _S8;
    nothing_2.weft_1 = _S8;
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
    var _S9 : f32 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    var quality_0 : SearchQuality_0;
    var _S10 : f32 = mix(2.5f, 5.0f, _S9);
    quality_0.steps_per_thread_0 = _S10;
    quality_0.steps_per_relief_0 = _S10;
    quality_0.shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S9);
    quality_0.refinements_0 = u32(mix(1.0f, 2.0f, _S9) + 0.5f);
    return quality_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_0 : f32) -> vec2<f32>
{
    var _S11 : f32 = floor(fma(index_0, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S11, fma(- _S11, families_0[family_0].count_0, index_0));
}

struct Cell_0
{
     thread_0 : u32,
     across_2 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_0 : f32) -> Cell_0
{
    var _S12 : f32 = floor(position_0 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S13 : f32 = fma(- _S12, families_0[family_1].size_0, position_0);
    cell_0.below_0 = _S13;
    cell_0.above_0 = families_0[family_1].size_0 - _S13;
    cell_0.across_2 = _S13 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S12).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn table_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_1])));
}

fn locate_varied_0( family_2 : u32,  position_1 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_1 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S14 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S15 : u32;
    if(_S14 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S15 = u32(1);
    }
    else
    {
        _S15 = u32(0);
    }
    var _S16 : u32 = min(thread_1 + _S15, u32(families_0[family_2].count_0) - u32(1));
    var _S17 : u32 = families_0[family_2].place_table_0 + _S16 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S16;
    cell_1.below_0 = _S14 - table_number_0(_S17);
    cell_1.above_0 = table_number_0(_S17 + u32(1)) - _S14;
    cell_1.across_2 = _S14 - table_number_0(_S17 + u32(2));
    cell_1.half_width_1 = table_number_0(_S17 + u32(3));
    return cell_1;
}

fn locate_0( family_3 : u32,  position_2 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
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
    var _S18 : bool = (abs(crossing_0.warp_2.across_2)) < (crossing_0.warp_2.half_width_1);
    var _S19 : bool = (abs(crossing_0.weft_2.across_2)) < (crossing_0.weft_2.half_width_1);
    var shown_0 : Shown_0;
    var _S20 : bool;
    if(_S18)
    {
        if(!_S19)
        {
            _S20 = true;
        }
        else
        {
            _S20 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S20 = false;
    }
    shown_0.is_warp_2 = _S20;
    if(!_S18)
    {
        _S20 = !_S19;
    }
    else
    {
        _S20 = false;
    }
    shown_0.hole_3 = _S20;
    var _S21 : u32;
    if(shown_0.is_warp_2)
    {
        _S21 = crossing_0.warp_word_0;
    }
    else
    {
        _S21 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S21;
    shown_0.on_top_0 = (((_S21 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_0 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_2 : Cell_0;
    var _S22 : u32;
    if(is_first_0)
    {
        _S22 = first_0.thread_0;
    }
    else
    {
        _S22 = second_0.thread_0;
    }
    cell_2.thread_0 = _S22;
    var _S23 : f32;
    if(is_first_0)
    {
        _S23 = first_0.across_2;
    }
    else
    {
        _S23 = second_0.across_2;
    }
    cell_2.across_2 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.half_width_1;
    }
    else
    {
        _S23 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.below_0;
    }
    else
    {
        _S23 = second_0.below_0;
    }
    cell_2.below_0 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.above_0;
    }
    else
    {
        _S23 = second_0.above_0;
    }
    cell_2.above_0 = _S23;
    return cell_2;
}

fn boundary_0( family_4 : u32,  thread_2 : u32,  step_0 : i32) -> f32
{
    var _S24 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_2) + step_0));
    return fma(_S24.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S24.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_3 : u32,  first_1 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_1) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_1);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_4 : u32) -> Bend_0
{
    var _S25 : Family_std430_0 = families_0[family_6];
    var _S26 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S26 = u32(0);
    }
    else
    {
        _S26 = thread_4 * u32(4);
    }
    var _S27 : u32 = _S25.bend_table_0 + _S26;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S27);
    bend_0.half_tangent_0 = table_number_0(_S27 + u32(1));
    bend_0.arc_0 = table_number_0(_S27 + u32(2));
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

fn unpack_0( own_0 : u32,  other_0 : u32,  thread_5 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S28 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S29 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S30 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S31 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S32 : i32 = - _S28;
    var _S33 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S32, i32(0));
    run_0.from_start_0 = _S33;
    var _S34 : i32 = _S29 + i32(1);
    var _S35 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, i32(1), _S34);
    run_0.to_end_0 = _S35;
    var _S36 : bool = _S33 < _S35;
    run_0.near_start_0 = _S36;
    var _S37 : i32;
    if(_S36)
    {
        _S37 = _S32 - _S30;
    }
    else
    {
        _S37 = _S34;
    }
    var _S38 : i32;
    if(run_0.near_start_0)
    {
        _S38 = _S32;
    }
    else
    {
        _S38 = _S34 + _S31;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    var _S39 : f32;
    if(run_0.straight_0)
    {
        _S39 = 1.0e+06f;
    }
    else
    {
        _S39 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S39;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S37, _S38), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S28 == i32(0);
    run_0.last_crossing_0 = _S29 == i32(0);
    return run_0;
}

fn square_0( x_3 : f32) -> f32
{
    return x_3 * x_3;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_3 : Cell_0) -> Section_0
{
    var _S40 : f32 = cell_3.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S41 : f32 = clamp(cell_3.across_2, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_3 = _S41;
    var _S42 : f32 = _S40 * _S40 - square_0(_S41);
    var _S43 : f32 = rsqrt_0(_S42);
    section_0.drop_0 = _S40 - _S42 * _S43;
    section_0.slope_0 = - _S41 * _S43;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_6 : u32,  step_1 : i32) -> f32
{
    if((families_0[family_7].is_alike_0) != u32(0))
    {
        return table_number_0(families_0[family_7].bend_table_0 + u32(3));
    }
    return table_number_0(families_0[family_7].bend_table_0 + u32(turns_and_remainder_0(family_7, f32(i32(thread_6) + step_1)).y) * u32(4) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S44 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S45 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S46 : f32;
    if(_S44)
    {
        _S46 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S46 = crossed_1.above_0 + crossed_1.across_2;
    }
    var _S47 : f32 = _S46 - crossed_1.half_width_1;
    var _S48 : bool;
    if(_S44)
    {
        _S48 = run_1.first_crossing_0;
    }
    else
    {
        _S48 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S46 = 0.0f;
    }
    else
    {
        _S46 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, i32(0));
    }
    var _S49 : f32;
    if((shown_1.on_top_0) != _S48)
    {
        _S49 = 0.0f;
    }
    else
    {
        var _S50 : Family_std430_0 = families_0[other_1];
        var _S51 : i32;
        if(_S44)
        {
            _S51 = i32(-1);
        }
        else
        {
            _S51 = i32(1);
        }
        _S49 = _S50.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, _S51);
    }
    var _S52 : f32 = 1.0f / max(2.0f * _S47, 9.999999960041972e-13f);
    var _S53 : f32 = clamp((_S47 - _S45) * _S52, 0.0f, 1.0f);
    var _S54 : f32 = _S46 + (_S49 - _S46) * (_S53 * _S53 * (3.0f - 2.0f * _S53));
    var _S55 : f32 = (_S46 - _S49) * (6.0f * _S53 * (1.0f - _S53) * _S52);
    if(_S44)
    {
        _S46 = 1.0f;
    }
    else
    {
        _S46 = -1.0f;
    }
    return vec2<f32>(_S54, _S55 * _S46);
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

fn step_control_0( direction_1 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S56 : f32 = direction_1.x;
    control_0.per_x_0 = 1.0f / max(abs(_S56), 9.99999971718068537e-10f);
    var _S57 : f32 = direction_1.y;
    control_0.per_y_0 = 1.0f / max(abs(_S57), 9.99999971718068537e-10f);
    control_0.right_0 = _S56 > 0.0f;
    control_0.up_0 = _S57 > 0.0f;
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

fn outline_distance_0( cell_4 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S58 : f32;
    if(forwards_0)
    {
        _S58 = cell_4.across_2;
    }
    else
    {
        _S58 = - cell_4.across_2;
    }
    var _S59 : f32;
    if(forwards_0)
    {
        _S59 = cell_4.above_0;
    }
    else
    {
        _S59 = cell_4.below_0;
    }
    var _S60 : bool;
    if(forwards_0)
    {
        _S60 = run_2.last_crossing_0;
    }
    else
    {
        _S60 = run_2.first_crossing_0;
    }
    var _S61 : bool;
    if(forwards_0)
    {
        _S61 = run_2.first_crossing_0;
    }
    else
    {
        _S61 = run_2.last_crossing_0;
    }
    var _S62 : f32 = - cell_4.half_width_1;
    var _S63 : bool = _S58 < _S62;
    var _S64 : bool = _S58 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S60 = !_S60;
    }
    else
    {
        _S60 = false;
    }
    if(_S60)
    {
        _S60 = !shown_2.hole_3;
    }
    else
    {
        _S60 = false;
    }
    var _S65 : bool;
    if(_S60)
    {
        _S65 = shown_2.on_top_0;
    }
    else
    {
        _S65 = false;
    }
    if(_S65)
    {
        if(_S61)
        {
            _S61 = _S63;
        }
        else
        {
            _S61 = false;
        }
        _S61 = !_S61;
    }
    else
    {
        _S61 = false;
    }
    if(shown_2.hole_3)
    {
        _S60 = true;
    }
    else
    {
        if(_S60)
        {
            _S60 = !shown_2.on_top_0;
        }
        else
        {
            _S60 = false;
        }
    }
    var _S66 : f32;
    if(_S63)
    {
        _S66 = _S62;
    }
    else
    {
        _S66 = cell_4.half_width_1;
    }
    var _S67 : f32 = _S66 - _S58;
    if(_S60)
    {
        _S58 = 2.0f * _S59 + _S58 - cell_4.half_width_1;
    }
    else
    {
        _S58 = _S59;
    }
    if(_S61)
    {
        if(forwards_0)
        {
            _S58 = run_2.to_end_0;
        }
        else
        {
            _S58 = run_2.from_start_0;
        }
        return _S58;
    }
    if(_S64)
    {
    }
    else
    {
        _S58 = _S67;
    }
    return _S58;
}

struct Probe_0
{
     height_3 : f32,
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
    var _S68 : f32 = previous_1.rate_0 * step_4;
    var _S69 : f32 = rate_1 * step_4;
    var _S70 : bool;
    if(!previous_1.known_0)
    {
        _S70 = true;
    }
    else
    {
        _S70 = here_0.hole_4;
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = rate_1 <= 0.0f;
    }
    if(_S70)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S68) >= 0.0f)
    {
        _S70 = (3.0f * clearance_1 - _S69) >= 0.0f;
    }
    else
    {
        _S70 = false;
    }
    if(_S70)
    {
        return -1.0f;
    }
    var _S71 : f32 = clearance_1 - previous_1.clearance_0;
    var _S72 : f32 = 6.0f * _S71 - 4.0f * _S68 - 2.0f * _S69;
    var _S73 : f32 = -2.0f * _S68 / max(_S72 + sqrt(max(_S72 * _S72 - 4.0f * (3.0f * (_S68 + _S69 - 2.0f * _S71)) * _S68, 0.0f)), 9.99999968265522539e-21f);
    var _S74 : f32 = 1.0f - _S73;
    var _S75 : f32 = (previous_1.clearance_0 * (2.0f * _S73 + 1.0f) + _S68 * _S73) * _S74 * _S74;
    var _S76 : f32 = (clearance_1 * (2.0f * _S74 + 1.0f) - _S69 * _S74) * _S73 * _S73;
    if(_S73 > 0.01999999955296516f)
    {
        _S70 = _S74 > 0.01999999955296516f;
    }
    else
    {
        _S70 = false;
    }
    if(_S70)
    {
        _S70 = (_S75 + _S76) < 0.0f;
    }
    else
    {
        _S70 = false;
    }
    var _S77 : f32;
    if(_S70)
    {
        _S77 = _S74 * step_4;
    }
    else
    {
        _S77 = -1.0f;
    }
    return _S77;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S78 : f32;
    if(here_1.hole_4)
    {
        _S78 = 1.0e+09f;
    }
    else
    {
        _S78 = clearance_2;
    }
    previous_2.clearance_0 = _S78;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S79 : bool;
    if(!here_1.hole_4)
    {
        _S79 = !is_cell_exit_0;
    }
    else
    {
        _S79 = false;
    }
    previous_2.known_0 = _S79;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S80 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    var _S81 : bool;
    if(!here_2.hole_4)
    {
        _S81 = (rate_3 * _S80 + clearance_3) < 0.0f;
    }
    else
    {
        _S81 = false;
    }
    if(_S81)
    {
        _S81 = _S80 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S81 = false;
    }
    var _S82 : f32;
    if(_S81)
    {
        _S82 = _S80 - this_2.epsilon_0;
    }
    else
    {
        _S82 = max(_S80, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S82);
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_4 : f32) -> vec2<f32>
{
    return this_3.origin_0 + this_3.slope_1 * vec2<f32>(height_4);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S83 : f32 = end_0 - start_1;
    var _S84 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S83;
    var _S85 : f32 = 3.0f * _S83 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S83, 9.99999968265522539e-21f);
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
        var _S86 : f32 = clamp(share_0 - (((_S84 * share_0 + _S85) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S84 * share_0 + 2.0f * _S85) * share_0 + start_rate_0, 0.10000000149011612f * _S83 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S87 : i32 = i_0 + i32(1);
        share_0 = _S86;
        i_0 = _S87;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S88 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S89 : f32 = rsqrt_0(_S88);
    var _S90 : f32 = sine_1 * _S89 * rsqrt_0(_S88 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S90 * _S88, _S90 * across_slope_0 * along_slope_0 + cosine_0 * _S89);
}

fn arc_sine_0( x_4 : f32) -> f32
{
    var _S91 : f32 = abs(x_4);
    var _S92 : bool = _S91 > 0.5f;
    var _S93 : f32;
    if(_S92)
    {
        _S93 = 0.5f * (1.0f - _S91);
    }
    else
    {
        _S93 = _S91 * _S91;
    }
    var _S94 : f32;
    if(_S92)
    {
        _S94 = sqrt(max(_S93, 0.0f));
    }
    else
    {
        _S94 = _S91;
    }
    var _S95 : f32 = ((((0.04216320067644119f * _S93 + 0.02418131195008755f) * _S93 + 0.04547002539038658f) * _S93 + 0.07495300471782684f) * _S93 + 0.16666752099990845f) * _S93 * _S94 + _S94;
    if(_S92)
    {
        _S93 = 1.57079637050628662f - 2.0f * _S95;
    }
    else
    {
        _S93 = _S95;
    }
    if(x_4 < 0.0f)
    {
        _S93 = - _S93;
    }
    return _S93;
}

fn table_colour_0( index_2 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_2), table_number_0(index_2 + u32(1)), table_number_0(index_2 + u32(2)));
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

fn albedos_of_0( family_8 : u32,  thread_7 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_8].albedo_table_0 + families_0[family_8].albedo_stride_0 * thread_7);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S96 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S97 : u32 = ((((_S96 >> ((((_S96 >> (u32(28)))) + u32(4))))) ^ (_S96))) * u32(277803737);
    return (((_S97 >> (u32(22)))) ^ (_S97));
}

fn uniform_hash_0( thread_8 : u32,  cell_5 : u32,  stream_0 : u32) -> f32
{
    return (f32(((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn thread_gain_0( thread_9 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_0 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S98 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_0, max(min(min(_S98.x, _S98.y), _S98.z), 0.0f));
}

fn fibre_gain_0( thread_10 : u32,  cell_6 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn diffuse_reflection_0( light_0 : vec3<f32>,  normal_2 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S99 : f32 = light_0.z;
    if(_S99 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S99, 0.0f), max(dot(light_0, normal_2), 0.0f), blend_0);
}

fn projected_area_1( direction_2 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S100 : f32 = dot(direction_2, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S100 * _S100 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S101 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S102 : f32 = floor(_S101 * 1.4426950216293335f + 0.5f);
    var _S103 : f32 = _S101 - _S102 * 0.693359375f + _S102 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S103 + 0.00139819993637502f) * _S103 + 0.00833345204591751f) * _S103 + 0.04166579619050026f) * _S103 + 0.1666666567325592f) * _S103 + 0.5f;
    var _S104 : f32 = (bitcast<f32>(((u32(i32(_S102) + i32(127)) << (u32(23))))));
    var _S105 : f32;
    if(x_5 < -87.0f)
    {
        _S105 = 0.0f;
    }
    else
    {
        _S105 = (p_0 * _S103 * _S103 + _S103 + 1.0f) * _S104;
    }
    return _S105;
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn square_1( v_0 : vec3<f32>) -> f32
{
    return dot(v_0, v_0);
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S106 : f32 = roughness_2 * roughness_2;
    var _S107 : f32 = squared_along_0 * (1.0f - _S106) + _S106;
    return 0.31830987334251404f * _S106 * roughness_2 / (_S107 * _S107);
}

fn density_between_0( light_1 : vec3<f32>,  view_0 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S108 : vec3<f32> = light_1 + view_0;
    var _S109 : f32 = dot(_S108, tangent_3);
    return flake_density_0(min(_S109 * _S109 / max(square_1(_S108), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_1( light_2 : vec3<f32>,  view_1 : vec3<f32>,  normal_3 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S110 : f32 = - dot(light_2, normal_3);
    var _S111 : f32 = dot(view_1, normal_3);
    var _S112 : bool;
    if(_S110 <= 0.0f)
    {
        _S112 = true;
    }
    else
    {
        _S112 = _S111 <= 0.0f;
    }
    if(_S112)
    {
        return 0.0f;
    }
    var _S113 : f32 = 1.0f / max(_S111, 9.99999997475242708e-07f);
    var _S114 : f32 = projected_area_1(light_2, tangent_4, roughness_4) / max(_S110, 9.99999997475242708e-07f);
    var _S115 : f32 = projected_area_1(view_1, tangent_4, roughness_4) * _S113;
    return density_between_0(light_2, view_1, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S114, _S115)) * mean_attenuation_0(optical_depth_1 * abs(_S114 - _S115)) * _S113;
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_4 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S116 : f32 = dot(light_3, normal_4);
    var _S117 : bool;
    if(_S116 <= 0.0f)
    {
        _S117 = true;
    }
    else
    {
        _S117 = (dot(view_2, normal_4)) <= 0.0f;
    }
    if(_S117)
    {
        return 0.0f;
    }
    var _S118 : f32 = max(_S116, 9.99999997475242708e-07f);
    var _S119 : f32 = max(dot(view_2, normal_4), 9.99999997475242708e-07f);
    var _S120 : f32 = projected_area_1(light_3, tangent_5, roughness_5) * _S119 + projected_area_1(view_2, tangent_5, roughness_5) * _S118;
    var _S121 : f32 = optical_depth_2 * _S120 / (_S118 * _S119);
    return 0.25f * density_between_0(light_3, view_2, tangent_5, roughness_5) * (_S121 * mean_attenuation_0(_S121)) * _S118 / _S120;
}

fn with_added_0( sums_0 : Components_0,  more_0 : Components_0,  weight_1 : f32) -> Components_0
{
    var result_0 : Components_0;
    result_0.diffuse_warp_0 = sums_0.diffuse_warp_0 + weight_1 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_0.diffuse_weft_0 + weight_1 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_0.specular_warp_0 + weight_1 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_0.specular_weft_0 + weight_1 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_0.light_visibility_1 + weight_1 * more_0.light_visibility_1;
    result_0.hole_2 = sums_0.hole_2 + weight_1 * more_0.hole_2;
    return result_0;
}

fn scaled_0( blocked_0 : Blocked_0,  share_1 : f32) -> Blocked_0
{
    var result_1 : Blocked_0;
    result_1.by_warp_0 = share_1 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_1 * blocked_0.by_weft_0;
    result_1.far_0 = share_1 * blocked_0.far_0;
    return result_1;
}

fn wrapped_cell_0( position_3 : f32,  count_1 : f32) -> f32
{
    return min(floor((position_3 - floor(position_3)) * count_1), count_1 - 1.0f);
}

fn arc_tangent_quotient_0( x_6 : f32,  y_0 : f32) -> f32
{
    return ((((((0.0f * x_6 + 0.00809729471802711f) * x_6 + -0.0377517081797123f) * x_6 + 0.08475969731807709f) * x_6 + -0.13537675142288208f) * x_6 + 0.19895026087760925f) * x_6 + -0.33327975869178772f) * x_6 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_1 : f32,  x_7 : f32) -> f32
{
    var _S122 : f32 = abs(x_7);
    var _S123 : f32 = abs(y_1);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S122, _S123) / max(max(_S122, _S123), 1.00000000317107685e-30f));
    var angle_1 : f32;
    if(_S123 > _S122)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_7 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_1 < 0.0f)
    {
        angle_1 = - angle_1;
    }
    return angle_1;
}

struct NodeTaps_0
{
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_0( direction_3 : vec3<f32>) -> NodeTaps_0
{
    var _S124 : f32 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    var _S125 : f32 = floor(_S124);
    var _S126 : f32 = _S124 - _S125;
    var _S127 : f32 = sqrt(clamp((1.0f - abs(direction_3.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S128 : f32 = 7.0f * _S127 * sqrt(_S127);
    var _S129 : f32 = min(floor(_S128), 6.0f);
    var _S130 : f32 = _S128 - _S129;
    var _S131 : u32 = u32(i32(_S125) + i32(32)) % u32(32);
    var _S132 : u32 = u32(_S129);
    var _S133 : u32 = _S131 * u32(8) + _S132;
    var _S134 : u32 = (_S131 + u32(1)) % u32(32) * u32(8) + _S132;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S133, _S133 + u32(1), _S134, _S134 + u32(1));
    var _S135 : f32 = 1.0f - _S126;
    var _S136 : f32 = 1.0f - _S130;
    var _S137 : vec4<u32> = vec4<u32>(vec4<f32>(_S135 * _S136, _S135 * _S130, _S126 * _S136, _S126 * _S130) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S137;
    taps_0.inverse_sum_0 = 1.0f / f32(_S137.x + _S137.y + _S137.z + _S137.w);
    return taps_0;
}

fn half_vector_0( light_4 : vec3<f32>,  view_3 : vec3<f32>) -> vec3<f32>
{
    var _S138 : vec3<f32> = light_4 + view_3;
    return _S138 * vec3<f32>(rsqrt_0(max(square_1(_S138), 9.999999960041972e-13f)));
}

fn shadow_correlation_0( light_5 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S139 : vec2<f32> = light_5.xy;
    var _S140 : vec2<f32> = view_4.xy;
    var _S141 : f32 = dot(_S139, _S140) / max(sqrt(dot(_S139, _S139) * dot(_S140, _S140)), 9.99999997475242708e-07f);
    if((light_5.z) < 0.0f)
    {
        return vec3<f32>(vec2<f32>((-0.09000000357627869f + -0.07999999821186066f * _S141)), 0.0f);
    }
    return vec3<f32>(min(0.62000000476837158f + 0.62999999523162842f * _S141, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_1 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S142 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S143 : vec4<u32> = ((packs_1 & (_S142))) * taps_1.weights_0;
    var _S144 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S142))) * taps_1.weights_0;
    return bytes_of_sums_0(_S143.x + _S143.y + _S143.z + _S143.w, _S144.x + _S144.y + _S144.z + _S144.w) * vec4<f32>(taps_1.inverse_sum_0);
}

fn interpolate_table_0( taps_2 : NodeTaps_0,  table_0 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S145 : vec4<u32> = vec4<u32>(table_0) + taps_2.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_2, vec4<u32>(words_0[_S145.x], words_0[_S145.y], words_0[_S145.z], words_0[_S145.w]));
}

struct Group_0
{
     normal_5 : vec3<f32>,
     weight_2 : f32,
     tangent_6 : vec3<f32>,
     variance_0 : vec3<f32>,
     covariance_0 : vec3<f32>,
     roughness_6 : f32,
};

fn group_at_0( row_1 : u32,  roughness_7 : f32) -> Group_0
{
    var group_0 : Group_0;
    group_0.normal_5 = vec3<f32>(table_number_0(row_1), table_number_0(row_1 + u32(1)), table_number_0(row_1 + u32(2)));
    group_0.weight_2 = table_number_0(row_1 + u32(3));
    var _S146 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_6 = _S146;
    var _S147 : f32 = table_number_0(row_1 + u32(7));
    var _S148 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S147, _S148, 1.0f - square_1(_S146) - _S147 - _S148);
    group_0.covariance_0 = vec3<f32>(table_number_0(row_1 + u32(9)), table_number_0(row_1 + u32(10)), table_number_0(row_1 + u32(11)));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

fn visibility_gain_0( correlations_0 : vec3<f32>,  from_light_0 : f32,  from_view_0 : f32) -> vec2<f32>
{
    return max(correlations_0.xy * vec2<f32>((1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f)) + vec2<f32>(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), vec2<f32>(0.0f));
}

fn Group_variance_along_0( this_5 : Group_0,  direction_4 : vec3<f32>) -> f32
{
    var _S149 : f32 = direction_4.x;
    var _S150 : f32 = direction_4.y;
    var _S151 : f32 = direction_4.z;
    return max(dot(this_5.variance_0, direction_4 * direction_4) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S149 * _S150, _S149 * _S151, _S150 * _S151)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_5 : vec3<f32>) -> f32
{
    var _S152 : f32 = dot(direction_5, group_1.tangent_6);
    var _S153 : f32 = group_1.roughness_6;
    var _S154 : f32 = _S153 * _S153;
    return sqrt(max((_S154 - 1.0f) * (_S152 * _S152 + Group_variance_along_0(group_1, direction_5)) + 1.0f, _S154));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S155 : f32 = group_2.roughness_6;
    var _S156 : f32 = max(sqrt(max(1.0f - _S155 * _S155, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S157 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S158 : f32 = dot(half_0, group_2.tangent_6);
    var _S159 : f32 = _S156 * (_S158 - _S157);
    var _S160 : f32 = _S156 * (_S158 + _S157);
    var _S161 : f32 = _S159 * _S160;
    var _S162 : f32 = 2.0f * _S157 * _S156;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S161) / ((_S159 * _S159 + 1.0f) * (_S160 * _S160 + 1.0f)) + arc_tangent_0(_S162, 1.0f + _S161) / _S162);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_6 : vec3<f32>,  view_5 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S163 : bool = (light_6.z) < 0.0f;
    var _S164 : f32 = dot(light_6, group_3.normal_5);
    var _S165 : f32;
    if(_S163)
    {
        _S165 = - _S164;
    }
    else
    {
        _S165 = _S164;
    }
    var _S166 : f32 = max(dot(view_5, group_3.normal_5), 0.01999999955296516f);
    var _S167 : f32 = mean_area_0(group_3, light_6) / max(_S165, 0.01999999955296516f);
    var _S168 : f32 = mean_area_0(group_3, view_5) / _S166;
    if(_S163)
    {
        _S165 = abs(_S167 - _S168);
    }
    else
    {
        _S165 = _S167 + _S168;
    }
    var _S169 : f32 = optical_depth_3 * max(_S165, 0.00100000004749745f);
    if(_S163)
    {
        _S165 = exponential_0(- optical_depth_3 * min(_S167, _S168));
    }
    else
    {
        _S165 = 1.0f;
    }
    var _S170 : f32 = optical_depth_3 * _S165 * (1.0f - exponential_0(- _S169)) / _S169 / _S166;
    if(_S163)
    {
        _S165 = 1.0f;
    }
    else
    {
        _S165 = 1.0f - 0.34999999403953552f * (1.0f - square_1(group_3.normal_5));
    }
    return 0.25f * mean_density_0(group_3, half_1) * _S165 * _S170;
}

struct Bound_0
{
     thread_11 : u32,
     turns_2 : f32,
     cell_7 : f32,
     visible_0 : f32,
     width_1 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_9 : u32,  position_4 : f32) -> Bound_0
{
    var _S171 : Cell_0 = locate_0(family_9, position_4);
    var _S172 : f32 = table_number_0(families_0[family_9].before_0 + u32(2) * _S171.thread_0 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_11 = _S171.thread_0;
    bound_0.turns_2 = round((position_4 - families_0[family_9].start_0 - _S172 - _S171.below_0) * families_0[family_9].inverse_period_0);
    bound_0.cell_7 = _S171.below_0;
    var _S173 : f32 = 2.0f * _S171.half_width_1;
    bound_0.width_1 = _S173;
    bound_0.visible_0 = clamp((_S171.across_2 + _S171.half_width_1) / _S173, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S171.below_0, _S171.below_0 - _S171.across_2 - _S171.half_width_1) + max(_S171.across_2 - _S171.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_0 : Bound_0,
     high_0 : Bound_0,
};

fn stretch_of_0( family_10 : u32,  centre_1 : f32,  size_1 : f32) -> Stretch_0
{
    var _S174 : f32 = centre_1 - floor((centre_1 - families_0[family_10].start_0) * families_0[family_10].inverse_period_0) * families_0[family_10].period_0;
    var _S175 : f32 = 0.5f * max(size_1, families_0[family_10].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_0 = bound_at_0(family_10, _S174 - _S175);
    stretch_0.high_0 = bound_at_0(family_10, _S174 + _S175);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_0.turns_2 - this_6.low_0.turns_2;
}

fn lengths_0( family_11 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S176 : f32 = Stretch_turns_0(stretch_1);
    var _S177 : u32 = families_0[family_11].before_0 + u32(2) * stretch_1.low_0.thread_11;
    var _S178 : u32 = families_0[family_11].before_0 + u32(2) * stretch_1.high_0.thread_11;
    var _S179 : f32 = table_number_0(_S178) - table_number_0(_S177);
    var _S180 : f32 = table_number_0(_S178 + u32(1)) - table_number_0(_S177 + u32(1));
    return vec3<f32>(_S179 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_1 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_1 + _S176 * families_0[family_11].visible_total_0, _S180 - _S179 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S176 * (families_0[family_11].period_0 - families_0[family_11].visible_total_0), _S180 + stretch_1.high_0.cell_7 - stretch_1.low_0.cell_7 + _S176 * families_0[family_11].period_0);
}

fn integrals_along_0( family_12 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S181 : Family_std430_0 = families_0[family_12];
    var _S182 : u32 = u32(3) * _S181.quantities_0;
    var _S183 : u32 = families_0[family_12].colour_threads_0 + _S182 * stretch_2.low_0.thread_11 + quantity_0;
    var _S184 : u32 = families_0[family_12].colour_threads_0 + _S182 * stretch_2.high_0.thread_11 + quantity_0;
    var _S185 : u32 = families_0[family_12].colour_threads_0 + _S182 * u32(families_0[family_12].count_0) + quantity_0;
    var _S186 : f32 = table_number_0(_S183);
    var _S187 : f32 = table_number_0(_S184);
    var _S188 : f32 = Stretch_turns_0(stretch_2);
    var _S189 : u32 = u32(2) * _S181.quantities_0;
    return vec2<f32>(table_number_0(_S184 + _S181.quantities_0) - table_number_0(_S183 + _S181.quantities_0) + _S187 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_1 - _S186 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_1 + _S188 * table_number_0(_S185 + _S181.quantities_0), table_number_0(_S184 + _S189) - table_number_0(_S183 + _S189) + _S187 * stretch_2.high_0.cell_7 - _S186 * stretch_2.low_0.cell_7 + _S188 * table_number_0(_S185 + _S189));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_0.thread_11) < (this_7.low_0.thread_11);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S190 : u32 = entries_0.z;
    var _S191 : u32 = entries_0.x;
    var _S192 : u32 = _S190 - _S191;
    var _S193 : u32;
    if(Stretch_wraps_0(this_8))
    {
        _S193 = whole_0;
    }
    else
    {
        _S193 = u32(0);
    }
    return vec4<u32>(_S192 + _S193, entries_0.w - _S190, entries_0.y - _S191, whole_0);
}

fn row_differences_0( across_4 : Stretch_0,  row_2 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S194 : u32 = row_2 + across_4.low_0.thread_11 * quantities_1;
    var _S195 : u32 = row_2 + across_4.high_0.thread_11 * quantities_1;
    return Stretch_differences_0(across_4, vec4<u32>(words_0[_S194], words_0[_S194 + quantities_1], words_0[_S195], words_0[_S195 + quantities_1]), words_0[row_2 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    var _S196 : f32 = - this_9.low_0.visible_0;
    var _S197 : f32 = Stretch_turns_0(this_9);
    var _S198 : f32;
    if(Stretch_wraps_0(this_9))
    {
        _S198 = 1.0f;
    }
    else
    {
        _S198 = 0.0f;
    }
    return vec4<f32>(1.0f, this_9.high_0.visible_0, _S196, _S197 - _S198);
}

fn integral_on_top_0( family_13 : u32,  across_5 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S199 : u32 = u32(families_0[family_13].count_0);
    var _S200 : u32 = (_S199 + u32(1)) * families_0[family_13].quantities_0;
    var _S201 : u32 = families_0[family_13].colour_areas_0 + quantity_1;
    var _S202 : vec4<u32> = row_differences_0(across_5, _S201 + along_0.low_0.thread_11 * _S200, _S199, families_0[family_13].quantities_0);
    var _S203 : vec4<u32> = row_differences_0(across_5, _S201 + (along_0.low_0.thread_11 + u32(1)) * _S200, _S199, families_0[family_13].quantities_0);
    var _S204 : vec4<u32> = row_differences_0(across_5, _S201 + along_0.high_0.thread_11 * _S200, _S199, families_0[family_13].quantities_0);
    var _S205 : vec4<u32> = row_differences_0(across_5, _S201 + (along_0.high_0.thread_11 + u32(1)) * _S200, _S199, families_0[family_13].quantities_0);
    var _S206 : vec4<u32> = row_differences_0(across_5, _S201 + crossing_count_0 * _S200, _S199, families_0[family_13].quantities_0);
    var _S207 : vec4<u32> = _S204 - _S202;
    var _S208 : vec4<u32>;
    if(Stretch_wraps_0(along_0))
    {
        _S208 = _S206;
    }
    else
    {
        _S208 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S209 : vec4<f32> = Stretch_weights_0(across_5);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S207 + _S208)), _S209), dot(vec4<f32>(vec4<i32>(_S205 - _S204)), _S209), dot(vec4<f32>(vec4<i32>(_S203 - _S202)), _S209), dot(vec4<f32>(vec4<i32>(_S206)), _S209)), Stretch_weights_0(along_0)) * families_0[family_13].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_3 : f32,  row_3 : u32) -> Albedos_0
{
    var _S210 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S211 : vec3<f32> = vec3<f32>(weight_3);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S211 * _S210.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S211 * _S210.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S211 * _S210.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S211 * _S210.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_14 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_4 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_14].colour_mean_0);
    if((families_0[family_14].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S212 : vec3<f32> = lengths_0(crossing_1, other_2);
    var is_exposed_0 : bool = false;
    var weight_4 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_14].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S213 : vec2<f32> = integrals_along_0(family_14, own_1, quantity_2);
        var _S214 : f32 = integral_on_top_0(family_14, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S215 : f32 = _S213.x;
        var _S216 : f32 = _S215 * _S212.x;
        var _S217 : f32;
        if(back_4)
        {
            _S217 = _S216 - _S214;
        }
        else
        {
            _S217 = _S214;
        }
        var _S218 : bool = quantity_2 == u32(0);
        if(_S218)
        {
            is_exposed_0 = _S217 > (16.0f * families_0[family_14].area_unit_0 * min(_S216 / families_0[family_14].crossing_area_0, 1.0f) + 0.00000999999974738f * _S216);
        }
        var _S219 : f32 = _S215 * _S212.y;
        var _S220 : f32;
        if(is_exposed_0)
        {
            _S220 = _S217;
        }
        else
        {
            _S220 = 0.0f;
        }
        var _S221 : f32 = _S219 + _S220 + 0.000244140625f * _S212.z * _S213.y;
        if(_S218)
        {
            weight_4 = 1.0f / max(_S221, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S221 * weight_4, families_0[family_14].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn lerp_albedos_0( first_2 : Albedos_0,  second_1 : Albedos_0,  weight_5 : f32) -> Albedos_0
{
    var albedos_3 : Albedos_0;
    var _S222 : vec3<f32> = vec3<f32>(weight_5);
    albedos_3.diffuse_reflect_0 = mix(first_2.diffuse_reflect_0, second_1.diffuse_reflect_0, _S222);
    albedos_3.diffuse_transmit_0 = mix(first_2.diffuse_transmit_0, second_1.diffuse_transmit_0, _S222);
    albedos_3.specular_reflect_0 = mix(first_2.specular_reflect_0, second_1.specular_reflect_0, _S222);
    albedos_3.specular_transmit_0 = mix(first_2.specular_transmit_0, second_1.specular_transmit_0, _S222);
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
    var _S223 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S224 : vec3<f32> = sends_0.sky_warp_0 + _S223 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S224;
    var _S225 : vec3<f32> = sends_0.sky_weft_0 + _S223 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S225;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S224 + vec3<f32>(sends_0.blocks_weft_0) * _S225;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_6 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S226 : f32 = 1.0f - view_6.z;
    var _S227 : f32 = _S226 * _S226;
    (*terms_0)[i32(0)] = 1.0f;
    var _S228 : f32 = view_6.x;
    var _S229 : f32 = _S228 * _S228;
    var _S230 : f32 = view_6.y;
    var _S231 : f32 = _S230 * _S230;
    (*terms_0)[i32(1)] = sqrt(max(_S229 + _S231, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S227;
    (*terms_0)[i32(3)] = _S227 * _S227;
    (*terms_0)[i32(4)] = _S229 - _S231;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_7 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S232 : f32 = 1.0f - view_7.z;
    var _S233 : f32 = _S232 * _S232;
    (*terms_1)[i32(0)] = 1.0f;
    var _S234 : f32 = view_7.x;
    var _S235 : f32 = _S234 * _S234;
    var _S236 : f32 = view_7.y;
    var _S237 : f32 = _S236 * _S236;
    (*terms_1)[i32(1)] = sqrt(max(_S235 + _S237, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S233;
    (*terms_1)[i32(3)] = _S233 * _S233;
    (*terms_1)[i32(4)] = _S235 - _S237;
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
     back_5 : vec3<f32>,
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
    var _S238 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S239 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_4 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_4) + _S239 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S239 * interior_0.far_1 + yarn_2.back_5 * _S238;
    return bounced_0;
}

fn sum_of_0( first_3 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_3.reflected_0 + second_2.reflected_0;
    sum_1.transmitted_0 = first_3.transmitted_0 + second_2.transmitted_0;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_8 : vec3<f32>) -> vec3<f32>
{
    var _S240 : f32 = light_7.z;
    var _S241 : vec3<f32>;
    if((_S240 * view_8.z) < 0.0f)
    {
        _S241 = bounced_1.transmitted_0;
    }
    else
    {
        _S241 = bounced_1.reflected_0;
    }
    return _S241 * vec3<f32>((abs(_S240) * 0.31830987334251404f));
}

fn sheen_scale_0( x_8 : f32,  y_2 : f32) -> f32
{
    return (((((0.0f * x_8 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_8 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_8 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_8 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_8 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_8 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

fn sheen_shear_0( x_9 : f32,  y_3 : f32) -> f32
{
    return ((((0.0f * x_9 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_9 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_9 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_9 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_9 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_10 : f32,  y_4 : f32) -> f32
{
    return ((((0.0f * x_10 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_10 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_10 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_10 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_10 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_8 : f32) -> vec3<f32>
{
    var _S242 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S243 : f32 = 2.0f * sqrt(_S242) - 1.0f;
    var _S244 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S243, _S244), 0.00999999977648258f, 1.0f), clamp((1.0f - _S242) * sheen_shear_0(_S243, _S244), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S243, _S244), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_8 : vec3<f32>,  view_9 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S245 : f32 = light_8.z;
    var _S246 : bool;
    if(_S245 <= 0.0f)
    {
        _S246 = true;
    }
    else
    {
        _S246 = (view_9.z) <= 0.0f;
    }
    if(_S246)
    {
        return 0.0f;
    }
    var _S247 : vec2<f32> = view_9.xy;
    var _S248 : f32 = dot(_S247, _S247);
    var _S249 : vec2<f32>;
    if(_S248 > 9.99999968265522539e-21f)
    {
        _S249 = _S247 * vec2<f32>(rsqrt_0(_S248));
    }
    else
    {
        _S249 = vec2<f32>(1.0f, 0.0f);
    }
    var _S250 : f32 = scale_0 * dot(light_8.xy, _S249) + shear_0 * _S245;
    var _S251 : f32 = scale_0 * (light_8.y * _S249.x - light_8.x * _S249.y);
    var _S252 : f32 = _S250 * _S250 + _S251 * _S251 + _S245 * _S245;
    return 0.31830987334251404f * scale_0 * scale_0 * _S245 / max(_S252 * _S252, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_9 : vec3<f32>,  view_10 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S253 : vec3<f32> = sheen_lobe_0(view_10.z, roughness_9);
    var _S254 : f32 = strength_0 * _S253.z;
    return vec2<f32>(_S254 * transformed_cosine_0(light_9, view_10, _S253.x, _S253.y), 1.0f - _S254);
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

fn regime_of_0( _S255 : u32,  _S256 : Footprint_0,  _S257 : f32) -> Regime_0
{
    var _S258 : f32 = Footprint_spread_side_0(_S256);
    var _S259 : f32 = clamp((binary_logarithm_0(max(_S258, 9.99999971718068537e-10f)) - fabrics_0[_S255].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S260 : f32 = _S259 * _S259 * (3.0f - 2.0f * _S259);
    regime_0.prefiltered_0 = _S260;
    regime_0.threads_1 = _S258 * fabrics_0[_S255].lobes_0.threads_per_mm_0;
    var _S261 : f32 = mix(max(8.0f / _S257, 1.0f), 1.0f, _S260);
    var _S262 : f32;
    if(_S260 < 1.0f)
    {
        _S262 = clamp(regime_0.threads_1 * 12.0f, 1.0f, _S261);
    }
    else
    {
        _S262 = 0.0f;
    }
    regime_0.points_0 = _S262;
    return regime_0;
}

struct Hit_0
{
     x_11 : f32,
     y_5 : f32,
     hole_5 : bool,
     height_5 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_6 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S263 : u32,  _S264 : f32,  _S265 : f32,  _S266 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_2 = locate_0(fabrics_0[_S263].warp_0, _S264);
    crossing_3.weft_2 = locate_0(fabrics_0[_S263].weft_0, _S265);
    var _S267 : u32 = fabrics_0[_S263].run_words_0 + u32(2) * (crossing_3.weft_2.thread_0 * fabrics_0[_S263].ends_1 + crossing_3.warp_2.thread_0);
    var _S268 : u32 = words_0[_S267];
    crossing_3.warp_word_0 = _S268;
    crossing_3.weft_word_0 = words_0[_S267 + u32(1)];
    crossing_3.warp_above_0 = (((_S268 & (u32(1)))) == u32(1)) != _S266;
    return crossing_3;
}

fn sample_at_0( _S269 : u32,  _S270 : f32,  _S271 : f32,  _S272 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S273 : Crossing_0 = crossing_at_0(_S269, _S270, _S271, _S272);
    sample_0.crossing_2 = _S273;
    var _S274 : Shown_0 = shown_at_0(_S273, _S272);
    sample_0.shown_3 = _S274;
    var _S275 : u32;
    if(_S274.is_warp_2)
    {
        _S275 = fabrics_0[_S269].warp_0;
    }
    else
    {
        _S275 = fabrics_0[_S269].weft_0;
    }
    var _S276 : u32;
    if(_S274.is_warp_2)
    {
        _S276 = fabrics_0[_S269].weft_0;
    }
    else
    {
        _S276 = fabrics_0[_S269].warp_0;
    }
    var _S277 : Cell_0 = select_cell_0(_S274.is_warp_2, sample_0.crossing_2.warp_2, sample_0.crossing_2.weft_2);
    var _S278 : Cell_0 = select_cell_0(_S274.is_warp_2, sample_0.crossing_2.weft_2, sample_0.crossing_2.warp_2);
    var _S279 : Run_0 = unpack_0(_S275, _S276, _S277.thread_0, _S278, _S274.word_0);
    var _S280 : Section_0 = section_at_0(_S277);
    var _S281 : bool;
    if(_S274.on_top_0)
    {
        _S281 = (_S279.distance_0) < (_S280.drop_0 * _S279.bend_1.sine_0);
    }
    else
    {
        _S281 = false;
    }
    var _S282 : bool;
    if(_S274.on_top_0)
    {
        _S282 = !_S281;
    }
    else
    {
        _S282 = false;
    }
    var _S283 : f32;
    if(_S282)
    {
        _S283 = 1.0f;
    }
    else
    {
        _S283 = -1.0f;
    }
    var _S284 : f32;
    if(_S281)
    {
        _S284 = _S279.other_reach_0;
    }
    else
    {
        _S284 = _S279.reach_0;
    }
    var _S285 : f32;
    if(_S281)
    {
        _S285 = _S284 + _S279.distance_0;
    }
    else
    {
        _S285 = max(_S284 - _S279.distance_0, 0.0f);
    }
    var _S286 : f32 = _S284 / _S279.bend_1.sine_0 - _S283 * _S280.drop_0;
    var _S287 : f32 = _S285 * _S285;
    var _S288 : f32 = max(_S286 * _S286 - _S287, 9.99999968265522539e-21f);
    var _S289 : f32 = rsqrt_0(_S288);
    var _S290 : f32 = _S287 / (_S288 * _S289 + _S286);
    var _S291 : bool = _S285 > 0.0f;
    var _S292 : f32;
    if(_S274.on_top_0)
    {
        _S292 = 1.0f;
    }
    else
    {
        _S292 = -1.0f;
    }
    var _S293 : f32;
    if(_S279.near_start_0)
    {
        _S293 = 1.0f;
    }
    else
    {
        _S293 = -1.0f;
    }
    var _S294 : f32 = _S292 * _S293;
    if(_S291)
    {
        _S292 = _S286 * _S289;
    }
    else
    {
        _S292 = 1.0f;
    }
    sample_0.slope_across_0 = _S280.slope_0 * _S292;
    if(_S291)
    {
        _S285 = _S294 * _S285 * _S289;
    }
    else
    {
        _S285 = 0.0f;
    }
    sample_0.slope_along_0 = _S285;
    var _S295 : Family_std430_0 = families_0[_S275];
    var _S296 : vec2<f32> = dive_0(_S276, _S274, _S279, _S278);
    if(_S279.straight_0)
    {
        _S283 = 0.0f;
    }
    else
    {
        _S283 = _S295.height_scale_0 * _S283;
    }
    sample_0.height_6 = _S283 * (_S284 * _S279.bend_1.half_tangent_0 - _S290) - _S295.height_scale_0 * _S280.drop_0 - _S296.x;
    var _S297 : f32 = _S295.height_scale_0 * sample_0.slope_across_0;
    var _S298 : f32 = _S295.height_scale_0 * sample_0.slope_along_0 - _S296.y;
    if(_S274.is_warp_2)
    {
        _S283 = _S297;
    }
    else
    {
        _S283 = _S298;
    }
    sample_0.slope_x_1 = _S283;
    if(_S274.is_warp_2)
    {
        _S283 = _S298;
    }
    else
    {
        _S283 = _S297;
    }
    sample_0.slope_y_1 = _S283;
    sample_0.run_3 = _S279;
    sample_0.section_1 = _S280;
    return sample_0;
}

fn steps_per_length_0( _S299 : u32,  _S300 : SearchQuality_0,  _S301 : vec3<f32>) -> f32
{
    return max(max(abs(_S301.x) * fabrics_0[_S299].threads_per_x_0, abs(_S301.y) * fabrics_0[_S299].threads_per_y_0) * _S300.steps_per_thread_0, abs(_S301.z) * fabrics_0[_S299].per_relief_0 * _S300.steps_per_relief_0);
}

fn cell_maximum_0( _S302 : u32,  _S303 : Crossing_0) -> f32
{
    var _S304 : u32;
    if(_S303.warp_above_0)
    {
        _S304 = fabrics_0[_S302].warp_0;
    }
    else
    {
        _S304 = fabrics_0[_S302].weft_0;
    }
    var _S305 : u32;
    if(_S303.warp_above_0)
    {
        _S305 = _S303.warp_word_0;
    }
    else
    {
        _S305 = _S303.weft_word_0;
    }
    return f32((_S305 >> (u32(28)))) * families_0[_S304].height_scale_0 * families_0[_S304].level_0;
}

fn probe_0( _S306 : u32,  _S307 : f32,  _S308 : f32,  _S309 : bool,  _S310 : bool,  _S311 : bool) -> Probe_0
{
    var _S312 : Sample_0 = sample_at_0(_S306, _S307, _S308, _S309);
    var probe_1 : Probe_0;
    probe_1.height_3 = _S312.height_6;
    probe_1.hole_4 = _S312.shown_3.hole_3;
    probe_1.slope_x_0 = _S312.slope_x_1;
    probe_1.slope_y_0 = _S312.slope_y_1;
    var _S313 : u32;
    if(_S312.shown_3.is_warp_2)
    {
        _S313 = _S312.crossing_2.warp_2.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S313 = _S312.crossing_2.weft_2.thread_0 * u32(2);
    }
    probe_1.yarn_1 = _S313;
    probe_1.cell_max_0 = cell_maximum_0(_S306, _S312.crossing_2);
    var _S314 : f32;
    if(_S310)
    {
        _S314 = _S312.crossing_2.warp_2.above_0;
    }
    else
    {
        _S314 = _S312.crossing_2.warp_2.below_0;
    }
    probe_1.side_x_0 = _S314;
    if(_S311)
    {
        _S314 = _S312.crossing_2.weft_2.above_0;
    }
    else
    {
        _S314 = _S312.crossing_2.weft_2.below_0;
    }
    probe_1.side_y_0 = _S314;
    probe_1.edge_x_0 = outline_distance_0(_S312.crossing_2.warp_2, _S312.shown_3, _S312.run_3, !_S312.shown_3.is_warp_2, _S310);
    probe_1.edge_y_0 = outline_distance_0(_S312.crossing_2.weft_2, _S312.shown_3, _S312.run_3, _S312.shown_3.is_warp_2, _S311);
    return probe_1;
}

fn is_free_0( _S315 : u32,  _S316 : SearchQuality_0,  _S317 : vec3<f32>,  _S318 : vec3<f32>,  _S319 : bool,  _S320 : f32) -> bool
{
    var _S321 : f32 = _S318.z;
    if(_S321 <= 0.0f)
    {
        return false;
    }
    var _S322 : f32 = 1.0f / max(_S316.shadow_share_0 * steps_per_length_0(_S315, _S316, _S318), 9.99999971718068537e-10f);
    var _S323 : StepControl_0 = step_control_0(_S318.xy, _S322);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S324 : bool;
        if(count_3 < u32(1024))
        {
            _S324 = (_S317.z + _S321 * distance_1) < _S320;
        }
        else
        {
            _S324 = false;
        }
        if(_S324)
        {
        }
        else
        {
            break;
        }
        var _S325 : vec3<f32> = _S317 + _S318 * vec3<f32>(distance_1);
        var _S326 : Probe_0 = probe_0(_S315, _S325.x, _S325.y, _S319, _S323.right_0, _S323.up_0);
        var _S327 : f32 = _S325.z;
        var _S328 : f32 = _S327 - _S326.height_3;
        var _S329 : f32 = _S321 - _S326.slope_x_0 * _S318.x - _S326.slope_y_0 * _S318.y;
        var _S330 : bool;
        if(!_S326.hole_4)
        {
            _S330 = _S328 < 0.0f;
        }
        else
        {
            _S330 = false;
        }
        if(_S330)
        {
            return false;
        }
        var _S331 : f32 = way_back_to_dip_0(previous_3, _S328, _S329, last_step_0, _S326);
        if(_S331 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S331;
            distance_1 = distance_1 - _S331;
            last_step_0 = last_step_1;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S332 : bool = _S327 > (_S326.cell_max_0);
        var _S333 : PreviousSample_0 = after_sample_0(_S328, _S329, _S326, _S332);
        var last_step_2 : f32;
        if(_S332)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S323, _S326.side_x_0, _S326.side_y_0), _S322);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S323, _S326, _S328, _S329);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S333;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S334 : u32,  _S335 : SearchQuality_0,  _S336 : f32,  _S337 : f32,  _S338 : vec3<f32>,  _S339 : bool) -> bool
{
    if(!sample_at_0(_S334, _S336, _S337, _S339).shown_3.hole_3)
    {
        return false;
    }
    var _S340 : vec3<f32> = vec3<f32>(_S336, _S337, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S341 : bool;
        if(side_0 < u32(2))
        {
            _S341 = passes_0;
        }
        else
        {
            _S341 = false;
        }
        if(_S341)
        {
        }
        else
        {
            break;
        }
        var _S342 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S342 = _S338;
        }
        else
        {
            _S342 = vec3<f32>(- _S338.x, - _S338.y, _S338.z);
        }
        var _S343 : bool = is_free_0(_S334, _S335, _S340, _S342, _S339 != (side_0 == u32(1)), fabrics_0[_S334].height_high_0);
        var _S344 : u32 = side_0 + u32(1);
        passes_0 = _S343;
        side_0 = _S344;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_7 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S345 : u32,  _S346 : f32,  _S347 : f32,  _S348 : f32,  _S349 : vec3<f32>,  _S350 : bool) -> f32
{
    var _S351 : u32 = locate_0(fabrics_0[_S345].warp_0, _S346).thread_0 / u32(2);
    var _S352 : u32 = locate_0(fabrics_0[_S345].weft_0, _S347).thread_0 / u32(2);
    var _S353 : f32 = _S349.x;
    var _S354 : u32;
    if(_S353 > 0.0f)
    {
        _S354 = u32(1);
    }
    else
    {
        _S354 = u32(0);
    }
    var _S355 : f32 = _S349.y;
    var _S356 : u32;
    if(_S355 > 0.0f)
    {
        _S356 = u32(2);
    }
    else
    {
        _S356 = u32(0);
    }
    var _S357 : u32 = words_0[fabrics_0[_S345].max_heights_0 + u32(4) * (_S352 * fabrics_0[_S345].max_height_columns_0 + _S351) + (_S354 + _S356)];
    var number_0 : i32;
    if(_S350)
    {
        number_0 = i32(4);
    }
    else
    {
        number_0 = i32(0);
    }
    var _S358 : u32 = (_S357 >> (u32(number_0)));
    var _S359 : f32 = max(abs(_S353) * fabrics_0[_S345].threads_per_x_0, abs(_S355) * fabrics_0[_S345].threads_per_y_0) / _S349.z;
    var _S360 : f32 = fabrics_0[_S345].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S345].height_high_0;
    number_0 = i32(3);
    for(;;)
    {
        if(number_0 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S348) * _S359) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S358 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S360);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S361 : u32,  _S362 : f32,  _S363 : f32,  _S364 : bool,  _S365 : bool,  _S366 : bool) -> vec3<f32>
{
    var _S367 : Crossing_0 = crossing_at_0(_S361, _S362, _S363, _S364);
    var _S368 : f32 = cell_maximum_0(_S361, _S367);
    var _S369 : f32;
    if(_S365)
    {
        _S369 = _S367.warp_2.above_0;
    }
    else
    {
        _S369 = _S367.warp_2.below_0;
    }
    var _S370 : f32;
    if(_S366)
    {
        _S370 = _S367.weft_2.above_0;
    }
    else
    {
        _S370 = _S367.weft_2.below_0;
    }
    return vec3<f32>(_S368, _S369, _S370);
}

fn first_sample_height_0( _S371 : u32,  _S372 : ViewRay_0,  _S373 : StepControl_0,  _S374 : bool) -> f32
{
    var _S375 : f32 = max_height_along_0(_S371, _S372.origin_0.x, _S372.origin_0.y, 0.0f, vec3<f32>(_S372.slope_1, 1.0f), _S374);
    var count_4 : u32 = u32(0);
    var height_8 : f32 = _S375;
    for(;;)
    {
        if(count_4 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S376 : vec2<f32> = ViewRay_at_0(_S372, height_8);
        var _S377 : vec3<f32> = cell_bounds_0(_S371, _S376.x, _S376.y, _S374, _S373.right_0, _S373.up_0);
        var _S378 : f32 = height_8 - _S377.x;
        var _S379 : f32 = StepControl_to_cell_exit_0(_S373, _S377.y, _S377.z);
        var height_9 : f32 = height_8 - clamp(_S378, 0.0f, _S379);
        if(_S378 <= _S379)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + u32(1);
        height_8 = height_9;
    }
    return height_8;
}

fn search_down_0( _S380 : u32,  _S381 : ViewRay_0,  _S382 : StepControl_0,  _S383 : bool) -> ViewRayEnd_0
{
    var _S384 : f32 = fabrics_0[_S380].height_low_0 - (fabrics_0[_S380].height_high_0 - fabrics_0[_S380].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_7 = first_sample_height_0(_S380, _S381, _S382, _S383);
    end_1.last_step_3 = _S382.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_5 : u32 = u32(0);
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S385 : vec2<f32> = ViewRay_at_0(_S381, end_1.height_7);
        var _S386 : Probe_0 = probe_0(_S380, _S385.x, _S385.y, _S383, _S382.right_0, _S382.up_0);
        var _S387 : f32 = end_1.height_7 - _S386.height_3;
        var _S388 : f32 = ViewRay_rate_0(_S381, _S386);
        end_1.depth_1 = - _S387;
        end_1.rate_4 = _S388;
        var _S389 : bool;
        if(end_1.previous_4.known_0)
        {
            _S389 = !_S386.hole_4;
        }
        else
        {
            _S389 = false;
        }
        var _S390 : bool;
        if(_S389)
        {
            _S390 = (end_1.previous_4.yarn_0) == (_S386.yarn_1);
        }
        else
        {
            _S390 = false;
        }
        end_1.smooth_0 = _S390;
        var _S391 : bool;
        if(!_S386.hole_4)
        {
            _S391 = _S387 <= 0.0f;
        }
        else
        {
            _S391 = false;
        }
        var _S392 : bool;
        if(_S391)
        {
            _S392 = true;
        }
        else
        {
            _S392 = (end_1.height_7) <= _S384;
        }
        if(_S392)
        {
            break;
        }
        var _S393 : f32 = way_back_to_dip_0(end_1.previous_4, _S387, _S388, end_1.last_step_3, _S386);
        if(_S393 >= 0.0f)
        {
            end_1.height_7 = end_1.height_7 + _S393;
            end_1.last_step_3 = end_1.last_step_3 - _S393;
            count_5 = count_5 + u32(1);
            continue;
        }
        var _S394 : f32 = min(StepControl_to_cell_exit_0(_S382, _S386.side_x_0, _S386.side_y_0), end_1.height_7 - _S386.cell_max_0);
        var _S395 : f32 = StepControl_to_next_sample_0(_S382, _S386, _S387, _S388);
        end_1.previous_4 = after_sample_0(_S387, _S388, _S386, _S394 > _S395);
        var _S396 : f32 = max(_S394, _S395);
        end_1.last_step_3 = _S396;
        end_1.height_7 = end_1.height_7 - _S396;
        count_5 = count_5 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S397 : u32,  _S398 : ViewRay_0,  _S399 : StepControl_0,  _S400 : bool,  _S401 : ViewRayEnd_0,  _S402 : u32) -> f32
{
    var _S403 : f32 = fabrics_0[_S397].height_high_0 - fabrics_0[_S397].height_low_0;
    var above_2 : f32 = _S401.height_7 + _S401.last_step_3;
    var above_gap_1 : f32 = clamp(_S401.previous_4.clearance_0, 0.0f, _S403);
    var under_gap_1 : f32 = clamp(_S401.depth_1, 0.0f, _S403);
    var _S404 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S401.previous_4.rate_0 * _S401.last_step_3, _S401.rate_4 * _S401.last_step_3);
    var middle_0 : f32;
    if(_S401.smooth_0)
    {
        middle_0 = above_2 - _S404 * _S401.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S401.height_7, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S401.height_7;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S402)
        {
        }
        else
        {
            break;
        }
        var _S405 : vec2<f32> = ViewRay_at_0(_S398, middle_0);
        var _S406 : Probe_0 = probe_0(_S397, _S405.x, _S405.y, _S400, _S399.right_0, _S399.up_0);
        var _S407 : f32;
        if(_S406.hole_4)
        {
            _S407 = -1.0e+09f;
        }
        else
        {
            _S407 = _S406.height_3;
        }
        var _S408 : f32 = clamp(middle_0 - _S407, - _S403, _S403);
        var _S409 : f32;
        if(_S408 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S409 = 0.5f * above_gap_2;
            }
            else
            {
                _S409 = above_gap_2;
            }
            var _S410 : f32 = - _S408;
            under_1 = middle_0;
            above_gap_2 = _S409;
            under_gap_2 = _S410;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S409 = 0.5f * under_gap_2;
            }
            else
            {
                _S409 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S408;
            under_gap_2 = _S409;
            side_1 = -1.0f;
        }
        if(_S401.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S408 / min(ViewRay_rate_0(_S398, _S406), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S401.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S411 : u32,  _S412 : SearchQuality_0,  _S413 : f32,  _S414 : f32,  _S415 : vec3<f32>,  _S416 : bool) -> Hit_0
{
    var _S417 : f32 = max(_S415.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S413, _S414);
    var _S418 : vec2<f32> = _S415.xy / vec2<f32>(_S417);
    ray_0.slope_1 = _S418;
    var _S419 : StepControl_0 = step_control_0((vec2<f32>(0) - _S418), 1.0f / max(steps_per_length_0(_S411, _S412, _S415) / _S417, 9.99999971718068537e-10f));
    var _S420 : ViewRayEnd_0 = search_down_0(_S411, ray_0, _S419, _S416);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S421 : f32 = refined_height_0(_S411, ray_0, _S419, _S416, _S420, _S412.refinements_0);
    hit_0.height_5 = _S421;
    var _S422 : vec2<f32> = ViewRay_at_0(ray_0, _S421);
    hit_0.x_11 = _S422.x;
    hit_0.y_5 = _S422.y;
    return hit_0;
}

fn first_hit_0( _S423 : u32,  _S424 : SearchQuality_0,  _S425 : f32,  _S426 : f32,  _S427 : vec3<f32>,  _S428 : bool) -> Hit_0
{
    if(!passes_through_0(_S423, _S424, _S425, _S426, _S427, _S428))
    {
        return first_hit_of_yarn_0(_S423, _S424, _S425, _S426, _S427, _S428);
    }
    var hit_1 : Hit_0;
    hit_1.x_11 = _S425;
    hit_1.y_5 = _S426;
    hit_1.height_5 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_at_0( _S429 : u32,  _S430 : f32,  _S431 : f32,  _S432 : bool) -> SurfacePoint_0
{
    var _S433 : Sample_0 = sample_at_0(_S429, _S430, _S431, _S432);
    var _S434 : f32;
    if(_S433.shown_3.is_warp_2)
    {
        _S434 = _S433.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S434 = _S433.crossing_2.weft_2.half_width_1;
    }
    var _S435 : u32;
    if(_S433.shown_3.is_warp_2)
    {
        _S435 = fabrics_0[_S429].warp_0;
    }
    else
    {
        _S435 = fabrics_0[_S429].weft_0;
    }
    var _S436 : Family_std430_0 = families_0[_S435];
    var _S437 : f32;
    if(_S432)
    {
        _S437 = -1.0f;
    }
    else
    {
        _S437 = 1.0f;
    }
    var _S438 : f32 = _S436.twist_sine_0 * _S437;
    var _S439 : Family_std430_0 = families_0[_S435];
    if(_S433.shown_3.is_warp_2)
    {
        _S437 = 1.0f;
    }
    else
    {
        _S437 = -1.0f;
    }
    var _S440 : vec2<f32> = fibre_direction_0(_S433.slope_across_0, _S437 * _S433.slope_along_0, _S438, _S439.twist_cosine_0);
    var _S441 : f32;
    if(_S433.shown_3.is_warp_2)
    {
        _S441 = _S433.slope_x_1;
    }
    else
    {
        _S441 = _S433.slope_y_1;
    }
    var _S442 : f32;
    if(_S433.shown_3.is_warp_2)
    {
        _S442 = _S433.slope_y_1;
    }
    else
    {
        _S442 = _S433.slope_x_1;
    }
    var _S443 : f32 = _S440.x;
    var _S444 : f32 = _S440.y;
    var _S445 : f32 = _S441 * _S443 + _S437 * _S442 * _S444;
    var _S446 : f32 = _S434 * 1.0154266357421875f;
    var _S447 : f32 = _S446 * arc_sine_0(clamp(_S433.section_1.across_3 / _S446, -1.0f, 1.0f));
    if(_S433.shown_3.is_warp_2)
    {
        _S434 = _S431;
    }
    else
    {
        _S434 = - _S430;
    }
    var point_0 : SurfacePoint_0;
    point_0.hole_0 = _S433.shown_3.hole_3;
    point_0.is_warp_0 = _S433.shown_3.is_warp_2;
    point_0.warp_thread_0 = _S433.crossing_2.warp_2.thread_0;
    point_0.weft_thread_0 = _S433.crossing_2.weft_2.thread_0;
    point_0.height_1 = _S433.height_6;
    point_0.normal_0 = normalize(vec3<f32>(- _S433.slope_x_1, - _S433.slope_y_1, 1.0f));
    var _S448 : vec3<f32>;
    if(_S433.shown_3.is_warp_2)
    {
        _S448 = vec3<f32>(_S443, _S444, _S445);
    }
    else
    {
        _S448 = vec3<f32>(- _S444, _S443, _S445);
    }
    point_0.tangent_0 = normalize(_S448);
    point_0.across_0 = _S433.section_1.across_3;
    point_0.fibre_across_0 = _S447 * _S439.twist_cosine_0 + _S434 * _S438;
    point_0.fibre_along_0 = _S434 * _S439.twist_cosine_0 - _S447 * _S438;
    return point_0;
}

struct YarnPoint_0
{
     back_6 : bool,
     hole_6 : bool,
     is_warp_3 : bool,
     x_12 : f32,
     y_6 : f32,
     height_10 : f32,
     normal_6 : vec3<f32>,
     tangent_7 : vec3<f32>,
     roughness_10 : f32,
     albedos_6 : Albedos_0,
};

fn vary_albedos_0( _S449 : u32,  _S450 : Albedos_0,  _S451 : u32,  _S452 : u32) -> Albedos_0
{
    var _S453 : vec3<f32> = max(_S450.specular_reflect_0, _S450.specular_transmit_0);
    var _S454 : vec3<f32> = _S450.diffuse_reflect_0 + _S450.diffuse_transmit_0;
    var _S455 : vec3<f32> = vec3<f32>(fabrics_0[_S449].layer_bound_0);
    var _S456 : vec3<f32> = vec3<f32>(1.0f);
    var _S457 : vec3<f32> = vec3<f32>(bounded_gain_0(thread_gain_0(_S451, fabrics_0[_S449].colour_noise_0, fabrics_0[_S449].seed_0), _S454, _S456 - _S455 * _S453));
    var _S458 : f32 = bounded_gain_0(fibre_gain_0(_S451, _S452, fabrics_0[_S449].fibre_noise_0, fabrics_0[_S449].seed_0), _S453, min((_S456 - _S457 * _S454) / _S455, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S457 * _S450.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S457 * _S450.diffuse_transmit_0;
    var _S459 : vec3<f32> = vec3<f32>(_S458);
    varied_0.specular_reflect_0 = _S459 * _S450.specular_reflect_0;
    varied_0.specular_transmit_0 = _S459 * _S450.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S460 : u32,  _S461 : SurfacePoint_0,  _S462 : Albedos_0,  _S463 : f32,  _S464 : f32) -> Albedos_0
{
    var _S465 : f32;
    if(_S461.is_warp_0)
    {
        _S465 = _S463;
    }
    else
    {
        _S465 = _S464;
    }
    var _S466 : f32 = _S465 - _S461.across_0;
    var _S467 : u32;
    if(_S461.is_warp_0)
    {
        _S467 = fabrics_0[_S460].warp_0;
    }
    else
    {
        _S467 = fabrics_0[_S460].weft_0;
    }
    var _S468 : Family_std430_0 = families_0[_S467];
    var _S469 : i32 = i32(families_0[_S467].count_0);
    if(_S461.is_warp_0)
    {
        _S467 = _S461.warp_thread_0;
    }
    else
    {
        _S467 = _S461.weft_thread_0;
    }
    var _S470 : u32 = u32(i32(floor(_S466 / _S468.period_0)) * _S469 + i32(_S467)) * u32(2);
    if(_S461.is_warp_0)
    {
        _S467 = u32(1);
    }
    else
    {
        _S467 = u32(0);
    }
    var _S471 : f32 = floor(_S461.fibre_across_0 / fabrics_0[_S460].fibre_size_0);
    return vary_albedos_0(_S460, _S462, _S470 + _S467, u32(i32(_S471)) * u32(65536) + u32(i32(floor(_S461.fibre_along_0 / (fabrics_0[_S460].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S471))));
}

fn yarn_point_of_0( _S472 : u32,  _S473 : SurfacePoint_0,  _S474 : f32,  _S475 : f32,  _S476 : bool,  _S477 : bool) -> YarnPoint_0
{
    var _S478 : u32;
    if(_S473.is_warp_0)
    {
        _S478 = fabrics_0[_S472].warp_0;
    }
    else
    {
        _S478 = fabrics_0[_S472].weft_0;
    }
    var _S479 : u32;
    if(_S473.is_warp_0)
    {
        _S479 = _S473.warp_thread_0;
    }
    else
    {
        _S479 = _S473.weft_thread_0;
    }
    var albedos_7 : Albedos_0 = albedos_of_0(_S478, _S479);
    var _S480 : bool;
    if((fabrics_0[_S472].fibre_noise_0) > 0.0f)
    {
        _S480 = true;
    }
    else
    {
        _S480 = (fabrics_0[_S472].colour_noise_0) > 0.0f;
    }
    var albedos_8 : Albedos_0;
    if(_S480)
    {
        albedos_8 = varied_at_0(_S472, _S473, albedos_7, _S474, _S475);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    var point_1 : YarnPoint_0;
    point_1.back_6 = _S476;
    point_1.hole_6 = _S477;
    point_1.is_warp_3 = _S473.is_warp_0;
    point_1.x_12 = _S474;
    point_1.y_6 = _S475;
    point_1.height_10 = _S473.height_1;
    point_1.normal_6 = _S473.normal_0;
    point_1.tangent_7 = _S473.tangent_0;
    point_1.roughness_10 = families_0[_S478].roughness_0;
    point_1.albedos_6 = albedos_8;
    return point_1;
}

fn unoccluded_0( _S481 : u32,  _S482 : SearchQuality_0,  _S483 : f32,  _S484 : f32,  _S485 : f32,  _S486 : vec3<f32>,  _S487 : bool) -> bool
{
    if((_S486.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S481, _S482, vec3<f32>(_S483, _S484, _S485 + fabrics_0[_S481].lift_0), _S486, _S487, max_height_along_0(_S481, _S483, _S484, _S485, _S486, _S487));
}

fn is_lit_0( _S488 : u32,  _S489 : SearchQuality_0,  _S490 : YarnPoint_0,  _S491 : vec3<f32>) -> bool
{
    if(_S490.hole_6)
    {
        return true;
    }
    var _S492 : vec3<f32> = to_face_frame_0(_S491, _S490.back_6);
    var _S493 : f32 = _S492.z;
    var _S494 : bool = _S493 < 0.0f;
    var normal_7 : vec3<f32>;
    var height_11 : f32;
    if(_S494)
    {
        var _S495 : SurfacePoint_0 = surface_at_0(_S488, _S490.x_12, _S490.y_6, !_S490.back_6);
        normal_7 = _S495.normal_0;
        height_11 = _S495.height_1;
    }
    else
    {
        normal_7 = _S490.normal_6;
        height_11 = _S490.height_10;
    }
    var _S496 : vec3<f32> = vec3<f32>(_S492.xy, abs(_S493));
    if((dot(normal_7, _S496)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S488, _S489, _S490.x_12, _S490.y_6, height_11, _S496, (_S490.back_6) != _S494);
}

fn components_of_point_0( _S497 : u32,  _S498 : SearchQuality_0,  _S499 : YarnPoint_0,  _S500 : vec3<f32>,  _S501 : vec3<f32>) -> Components_0
{
    var result_3 : Components_0 = no_components_0();
    var _S502 : f32;
    if(_S499.hole_6)
    {
        _S502 = 1.0f;
    }
    else
    {
        _S502 = 0.0f;
    }
    result_3.hole_2 = _S502;
    var _S503 : bool;
    if(_S499.hole_6)
    {
        _S503 = true;
    }
    else
    {
        _S503 = !is_lit_0(_S497, _S498, _S499, _S500);
    }
    if(_S503)
    {
        return result_3;
    }
    var _S504 : vec3<f32> = to_face_frame_0(_S500, _S499.back_6);
    var _S505 : vec3<f32> = to_face_frame_0(_S501, _S499.back_6);
    var _S506 : bool = (_S504.z) < 0.0f;
    var _S507 : vec3<f32>;
    if(_S506)
    {
        _S507 = (vec3<f32>(0) - _S504);
    }
    else
    {
        _S507 = _S504;
    }
    var _S508 : f32 = diffuse_reflection_0(_S507, _S499.normal_6, fabrics_0[_S497].diffuse_blend_0);
    if(_S506)
    {
        _S502 = transmission_1(_S504, _S505, _S499.normal_6, _S499.tangent_7, _S499.roughness_10, fabrics_0[_S497].optical_depth_0);
    }
    else
    {
        _S502 = reflection_0(_S504, _S505, _S499.normal_6, _S499.tangent_7, _S499.roughness_10, fabrics_0[_S497].optical_depth_0);
    }
    var _S509 : f32;
    if(_S499.is_warp_3)
    {
        _S509 = _S508;
    }
    else
    {
        _S509 = 0.0f;
    }
    result_3.diffuse_warp_0 = _S509;
    if(_S499.is_warp_3)
    {
        _S509 = 0.0f;
    }
    else
    {
        _S509 = _S508;
    }
    result_3.diffuse_weft_0 = _S509;
    if(_S499.is_warp_3)
    {
        _S509 = _S502;
    }
    else
    {
        _S509 = 0.0f;
    }
    result_3.specular_warp_0 = _S509;
    if(_S499.is_warp_3)
    {
        _S502 = 0.0f;
    }
    result_3.specular_weft_0 = _S502;
    result_3.light_visibility_1 = 1.0f;
    return result_3;
}

fn openness_number_0( _S510 : u32,  _S511 : u32) -> f32
{
    return table_number_0(fabrics_0[_S510].openness_0 + _S511);
}

fn blocked_of_terms_0( _S512 : u32,  _S513 : u32,  _S514 : array<f32, i32(6)>,  _S515 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_2 : u32 = u32(0);
    for(;;)
    {
        if(share_2 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_2] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S515)
            {
            }
            else
            {
                break;
            }
            shares_0[share_2] = shares_0[share_2] + openness_number_0(_S512, _S513 + share_2 * _S515 + term_0) * _S514[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_2] = saturate(shares_0[share_2]);
        share_2 = share_2 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_2.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_2.far_0 = shares_0[i32(1)];
    return blocked_2;
}

fn blocked_at_0( _S516 : u32,  _S517 : bool,  _S518 : bool,  _S519 : f32,  _S520 : f32) -> Blocked_0
{
    var _S521 : f32 = _S520 * openness_number_0(_S516, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S519, _S521, _S519 * _S519, _S519 * _S521, _S521 * _S521 );
    var _S522 : u32;
    if(_S518)
    {
        _S522 = u32(2);
    }
    else
    {
        _S522 = u32(0);
    }
    var _S523 : u32;
    if(_S517)
    {
        _S523 = u32(0);
    }
    else
    {
        _S523 = u32(1);
    }
    return blocked_of_terms_0(_S516, u32(60) + (_S522 + _S523) * u32(18), terms_2, u32(6));
}

fn with_blocked_0( _S524 : u32,  _S525 : Blocked_0,  _S526 : YarnPoint_0,  _S527 : bool,  _S528 : f32) -> Blocked_0
{
    var _S529 : bool;
    if(_S526.hole_6)
    {
        _S529 = true;
    }
    else
    {
        _S529 = (_S526.is_warp_3) != _S527;
    }
    if(_S529)
    {
        return _S525;
    }
    var _S530 : Blocked_0 = blocked_at_0(_S524, _S527, _S526.back_6, _S526.normal_6.z, _S526.height_10);
    var result_4 : Blocked_0;
    result_4.by_warp_0 = _S525.by_warp_0 + _S528 * _S530.by_warp_0;
    result_4.by_weft_0 = _S525.by_weft_0 + _S528 * _S530.by_weft_0;
    result_4.far_0 = _S525.far_0 + _S528 * _S530.far_0;
    return result_4;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S531 : u32,  _S532 : f32) -> vec3<f32>
{
    var _S533 : u32 = fabrics_0[_S531].lobes_0.levels_0 + u32(4) * u32(min(_S532, fabrics_0[_S531].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S533), table_number_0(_S533 + u32(1)), table_number_0(_S533 + u32(2)));
}

fn coverage_taps_0( _S534 : u32,  _S535 : Footprint_0,  _S536 : bool) -> CoverageTaps_0
{
    var _S537 : Lobes_std430_0 = fabrics_0[_S534].lobes_0;
    var _S538 : f32 = Footprint_spread_side_0(_S535) * fabrics_0[_S534].lobes_0.inverse_base_size_0;
    var _S539 : vec3<f32> = pyramid_level_0(_S534, floor(binary_logarithm_0(max(0.68000000715255737f * _S538, 1.0f))));
    var _S540 : f32 = 1.0f / max(_S538, 9.99999997475242708e-07f);
    var _S541 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S534].warp_0].inverse_period_0, families_0[fabrics_0[_S534].weft_0].inverse_period_0);
    var _S542 : vec2<f32> = _S535.centre_0 * _S541;
    var _S543 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S540 * _S540), 0.0f, 1.0f)), 0.3333333432674408f * _S540), 1.0f));
    var _S544 : vec2<f32> = _S535.dx_0 * _S541 * _S543;
    var _S545 : vec2<f32> = _S535.dy_0 * _S541 * _S543;
    var taps_3 : CoverageTaps_0;
    var number_1 : u32 = u32(0);
    for(;;)
    {
        if(number_1 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S546 : vec2<f32> = _S542 + vec2<f32>(TAP_OFFSETS_0[number_1].x) * _S544 + vec2<f32>(TAP_OFFSETS_0[number_1].y) * _S545;
        var _S547 : f32 = _S539.y;
        var _S548 : f32 = wrapped_cell_0(_S546.x, _S547);
        var _S549 : f32 = wrapped_cell_0(_S546.y, _S539.z);
        var _S550 : u32;
        if(_S536)
        {
            _S550 = _S537.face_nodes_0;
        }
        else
        {
            _S550 = u32(0);
        }
        taps_3.nodes_1[number_1] = _S550 + u32(_S549 * _S547 + _S548 + _S539.x);
        number_1 = number_1 + u32(1);
    }
    return taps_3;
}

fn coverage_of_pack_0( _S551 : u32,  _S552 : CoverageTaps_0,  _S553 : u32) -> vec4<f32>
{
    var number_2 : u32 = u32(0);
    var even_1 : u32 = u32(0);
    var odd_1 : u32 = u32(0);
    for(;;)
    {
        if(number_2 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S554 : u32 = words_0[fabrics_0[_S551].lobes_0.coverage_0 + _S552.nodes_1[number_2] * fabrics_0[_S551].lobes_0.packs_0 + _S553];
        var even_2 : u32 = even_1 + ((_S554 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S554 >> (u32(8)))) & (u32(16711935))));
        number_2 = number_2 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S555 : u32,  _S556 : CoverageTaps_0) -> f32
{
    var number_3 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(number_3 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S555].lobes_0.coverage_holes_0 + _S556.nodes_1[number_3] / u32(4)] >> ((u32(8) * (_S556.nodes_1[number_3] % u32(4)))))) & (u32(255))));
        number_3 = number_3 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S557 : u32,  _S558 : CoverageTaps_0,  _S559 : NodeTaps_0,  _S560 : bool) -> f32
{
    var _S561 : Lobes_std430_0 = fabrics_0[_S557].lobes_0;
    var _S562 : f32 = interpolate_table_0(_S559, fabrics_0[_S557].lobes_0.projected_area_0 + fabrics_0[_S557].lobes_0.packs_0, fabrics_0[_S557].lobes_0.packs_0 + u32(1)).x;
    var _S563 : f32;
    if(_S560)
    {
        _S563 = _S561.back_hole_weight_0;
    }
    else
    {
        _S563 = _S561.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S557, _S558) * _S562 * _S562 * _S563, 1.0f);
}

fn prefiltered_components_0( _S564 : u32,  _S565 : Footprint_0,  _S566 : vec3<f32>,  _S567 : vec3<f32>,  _S568 : bool) -> Components_0
{
    var _S569 : CoverageTaps_0 = coverage_taps_0(_S564, _S565, _S568);
    var _S570 : NodeTaps_0 = node_taps_0(_S567);
    var view_nodes_0 : NodeTaps_0 = _S570;
    var light_nodes_0 : NodeTaps_0 = node_taps_0(_S566);
    var seen_nodes_0 : NodeTaps_0 = _S570;
    var _S571 : u32;
    if(_S568)
    {
        _S571 = u32(1);
    }
    else
    {
        _S571 = u32(0);
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S571 * u32(256)));
    var _S572 : u32 = u32(2) * _S571;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + vec4<u32>((_S572 * u32(256)));
    var _S573 : u32;
    if((_S566.z) < 0.0f)
    {
        _S573 = u32(1);
    }
    else
    {
        _S573 = u32(0);
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((_S572 + _S573) * u32(256)));
    var _S574 : vec3<f32> = half_vector_0(_S566, _S567);
    var _S575 : vec3<f32> = shadow_correlation_0(_S566, _S567);
    if(_S568)
    {
        _S573 = fabrics_0[_S564].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S573 = fabrics_0[_S564].lobes_0.front_warp_packs_0;
    }
    var sums_1 : Components_0;
    sums_1.diffuse_warp_0 = 0.0f;
    sums_1.diffuse_weft_0 = 0.0f;
    sums_1.specular_warp_0 = 0.0f;
    sums_1.specular_weft_0 = 0.0f;
    sums_1.light_visibility_1 = 0.0f;
    var pack_0 : u32 = u32(0);
    var total_2 : f32 = 0.0f;
    for(;;)
    {
        var _S576 : Lobes_std430_0 = fabrics_0[_S564].lobes_0;
        if(pack_0 < (fabrics_0[_S564].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S577 : vec4<f32> = coverage_of_pack_0(_S564, _S569, pack_0);
        var _S578 : vec4<f32> = interpolate_table_0(view_nodes_0, _S576.projected_area_0 + pack_0, _S576.packs_0 + u32(1));
        var _S579 : u32 = _S576.light_visibility_0 + pack_0;
        var _S580 : vec4<f32> = vec4<f32>(255.0f);
        var _S581 : vec4<f32> = interpolate_table_0(seen_nodes_0, _S579, _S576.packs_0) / _S580;
        var _S582 : vec4<f32> = interpolate_table_0(light_nodes_0, _S579, _S576.packs_0) / _S580;
        var _S583 : vec4<f32> = interpolate_table_0(light_nodes_0, _S576.irradiance_0 + pack_0, _S576.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S584 : bool = pack_0 < _S573;
        var _S585 : u32;
        if(_S584)
        {
            _S585 = fabrics_0[_S564].warp_0;
        }
        else
        {
            _S585 = fabrics_0[_S564].weft_0;
        }
        var _S586 : Family_std430_0 = families_0[_S585];
        var number_4 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        for(;;)
        {
            if(number_4 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S587 : Group_0 = group_at_0(_S576.moments_0 + u32(12) * (u32(4) * (_S571 * _S576.packs_0 + pack_0) + number_4), _S586.roughness_0);
            var _S588 : f32 = _S577[number_4] * _S578[number_4] * _S578[number_4] * _S587.weight_2;
            var _S589 : vec2<f32> = visibility_gain_0(_S575, _S582[number_4], _S581[number_4]);
            var _S590 : f32 = _S589.x;
            var diffuse_1 : f32 = diffuse_0 + _S588 * _S583[number_4] * _S590;
            var specular_1 : f32 = specular_0 + _S588 * layer_value_0(_S587, _S574, _S566, _S567, fabrics_0[_S564].optical_depth_0) * _S582[number_4] * _S589.y;
            sums_1.light_visibility_1 = sums_1.light_visibility_1 + _S588 * _S582[number_4] * _S590;
            var total_3 : f32 = total_2 + _S588;
            number_4 = number_4 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        var _S591 : f32;
        if(_S584)
        {
            _S591 = diffuse_0;
        }
        else
        {
            _S591 = 0.0f;
        }
        sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 + _S591;
        var _S592 : f32;
        if(_S584)
        {
            _S592 = 0.0f;
        }
        else
        {
            _S592 = diffuse_0;
        }
        sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 + _S592;
        var _S593 : f32;
        if(_S584)
        {
            _S593 = specular_0;
        }
        else
        {
            _S593 = 0.0f;
        }
        sums_1.specular_warp_0 = sums_1.specular_warp_0 + _S593;
        var _S594 : f32;
        if(_S584)
        {
            _S594 = 0.0f;
        }
        else
        {
            _S594 = specular_0;
        }
        sums_1.specular_weft_0 = sums_1.specular_weft_0 + _S594;
        pack_0 = pack_0 + u32(1);
    }
    var _S595 : f32 = prefiltered_hole_0(_S564, _S569, view_nodes_0, _S568);
    sums_1.hole_2 = _S595;
    var _S596 : f32 = (1.0f - _S595) / max(total_2, 9.999999960041972e-13f);
    sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 * _S596;
    sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 * _S596;
    sums_1.specular_warp_0 = sums_1.specular_warp_0 * _S596;
    sums_1.specular_weft_0 = sums_1.specular_weft_0 * _S596;
    sums_1.light_visibility_1 = sums_1.light_visibility_1 * _S596;
    return sums_1;
}

fn albedos_over_0( _S597 : u32,  _S598 : Footprint_0,  _S599 : bool) -> FamilyAlbedos_0
{
    var _S600 : vec2<f32> = _S598.dx_0;
    var _S601 : vec2<f32> = _S598.dy_0;
    var _S602 : vec2<f32> = sqrt(_S600 * _S600 + _S601 * _S601);
    var _S603 : Stretch_0 = stretch_of_0(fabrics_0[_S597].warp_0, _S598.centre_0.x, _S602.x);
    var _S604 : Stretch_0 = stretch_of_0(fabrics_0[_S597].weft_0, _S598.centre_0.y, _S602.y);
    var albedos_9 : FamilyAlbedos_0;
    albedos_9.warp_5 = mean_albedos_0(fabrics_0[_S597].warp_0, fabrics_0[_S597].weft_0, _S603, _S604, _S599);
    albedos_9.weft_5 = mean_albedos_0(fabrics_0[_S597].weft_0, fabrics_0[_S597].warp_0, _S604, _S603, _S599);
    return albedos_9;
}

fn lobes_estimate_of_pass_0( _S605 : u32,  _S606 : Footprint_0,  _S607 : f32,  _S608 : vec2<f32>,  _S609 : vec3<f32>,  _S610 : vec3<f32>) -> Estimate_0
{
    var _S611 : f32;
    var _S612 : Regime_0 = regime_of_0(_S605, _S606, _S607);
    var _S613 : bool = (_S610.z) < 0.0f;
    var _S614 : vec3<f32> = to_face_frame_0(_S610, _S613);
    var _S615 : bool;
    if((fabrics_0[_S605].fibre_noise_0) > 0.0f)
    {
        _S615 = true;
    }
    else
    {
        _S615 = (fabrics_0[_S605].colour_noise_0) > 0.0f;
    }
    var _S616 : bool;
    if((families_0[fabrics_0[_S605].warp_0].quantities_0) > u32(1))
    {
        _S616 = true;
    }
    else
    {
        _S616 = (families_0[fabrics_0[_S605].weft_0].quantities_0) > u32(1);
    }
    var _S617 : f32 = 1.0f - _S612.prefiltered_0;
    if(_S617 > 0.0f)
    {
        if(_S615)
        {
            _S616 = true;
        }
    }
    else
    {
        _S616 = false;
    }
    var box_0 : Footprint_0 = _S606;
    var _S618 : vec3<f32> = vec3<f32>(0.0f);
    var _S619 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S618, _S618, 0.0f, 0.0f, 0.0f);
    var _S620 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S621 : i32;
    if(_S616)
    {
        _S621 = i32(0);
    }
    else
    {
        _S621 = i32(1);
    }
    var _S622 : u32 = u32(_S621);
    var points_1 : Components_0 = _S620;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S619;
    var central_place_0 : vec2<f32> = _S606.centre_0;
    var number_5 : u32 = _S622;
    for(;;)
    {
        var _S623 : f32 = f32(number_5);
        _S611 = _S612.points_0;
        if(_S623 < (_S612.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S624 : bool = number_5 == u32(0);
        var _S625 : u32;
        if(_S624)
        {
            _S625 = u32(0);
        }
        else
        {
            _S625 = number_5 - u32(1);
        }
        var _S626 : vec2<f32> = POINT_OFFSETS_0[_S625] + _S608;
        var _S627 : vec2<f32>;
        if(_S624)
        {
            _S627 = vec2<f32>(0.0f);
        }
        else
        {
            _S627 = _S626 - round(_S626);
        }
        var _S628 : vec2<f32> = _S606.centre_0 + vec2<f32>(_S627.x) * _S606.dx_0 + vec2<f32>(_S627.y) * _S606.dy_0;
        var _S629 : f32;
        if(_S624)
        {
            _S629 = 0.0f;
        }
        else
        {
            _S629 = _S612.threads_1;
        }
        var _S630 : SearchQuality_0 = quality_of_0(_S629);
        var _S631 : Hit_0 = first_hit_0(_S605, _S630, _S628.x, _S628.y, _S614, _S613);
        var _S632 : SurfacePoint_0 = surface_at_0(_S605, _S631.x_11, _S631.y_5, _S613);
        if(_S624)
        {
            var central_weight_1 : f32;
            if(_S631.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S617;
            }
            var central_place_1 : vec2<f32> = vec2<f32>(_S631.x_11, _S631.y_5);
            box_0.centre_0 = mix(_S606.centre_0, central_place_1, vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S632;
            central_place_0 = central_place_1;
            number_5 = number_5 + u32(1);
            continue;
        }
        var _S633 : YarnPoint_0 = yarn_point_of_0(_S605, _S632, _S631.x_11, _S631.y_5, _S613, _S631.hole_5);
        var _S634 : f32 = min(_S612.points_0 - f32(number_5 - u32(1)), 1.0f);
        var _S635 : Components_0 = with_added_0(points_1, components_of_point_0(_S605, _S630, _S633, _S609, _S610), _S634);
        if((fabrics_0[_S605].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S605, close_1.warp_1, _S633, true, _S634);
            close_1.weft_1 = with_blocked_0(_S605, close_1.weft_1, _S633, false, _S634);
        }
        points_1 = _S635;
        number_5 = number_5 + u32(1);
    }
    close_1.weight_0 = _S617;
    var _S636 : f32 = max(_S611, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S636);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S636);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S620, points_1, _S617 / _S636);
    if((_S612.prefiltered_0) > 0.0f)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S605, _S606, to_face_frame_0(_S609, _S613), _S614, _S613), _S612.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S605, box_0, _S613);
    if(_S615)
    {
        _S615 = central_weight_0 > 0.0f;
    }
    else
    {
        _S615 = false;
    }
    if(_S615)
    {
        var _S637 : SurfacePoint_0 = central_0;
        var _S638 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S638 = estimate_0.albedos_5.warp_5;
        }
        else
        {
            _S638 = estimate_0.albedos_5.weft_5;
        }
        var _S639 : Albedos_0 = lerp_albedos_0(_S638, varied_at_0(_S605, central_0, _S638, central_place_0.x, central_place_0.y), central_weight_0);
        if(_S637.is_warp_0)
        {
            estimate_0.albedos_5.warp_5 = _S639;
        }
        else
        {
            estimate_0.albedos_5.weft_5 = _S639;
        }
    }
    return estimate_0;
}

fn lobes_estimate_0( _S640 : u32,  _S641 : Footprint_0,  _S642 : f32,  _S643 : vec3<f32>,  _S644 : vec3<f32>) -> Estimate_0
{
    return lobes_estimate_of_pass_0(_S640, _S641, _S642, vec2<f32>(0.0f), _S643, _S644);
}

fn scattered_by_0( _S645 : u32,  _S646 : Albedos_0,  _S647 : u32,  _S648 : vec3<f32>) -> Scattered_0
{
    var _S649 : u32 = u32(159) + u32(2) * _S647;
    var yarn_3 : Scattered_0;
    yarn_3.back_5 = _S648 * _S646.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S645, _S649)) * _S646.specular_reflect_0;
    yarn_3.through_0 = _S648 * _S646.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S645, _S649 + u32(1))) * _S646.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S650 : u32,  _S651 : u32,  _S652 : vec3<f32>,  _S653 : vec3<f32>,  _S654 : vec3<f32>,  _S655 : vec3<f32>,  _S656 : ptr<function, vec3<f32>>,  _S657 : ptr<function, vec3<f32>>)
{
    var _S658 : u32 = u32(146) + u32(4) * _S651;
    var _S659 : f32 = openness_number_0(_S650, _S658 + u32(1));
    var _S660 : f32 = openness_number_0(_S650, _S658 + u32(2));
    var _S661 : vec3<f32> = vec3<f32>(1.0f);
    var _S662 : vec3<f32> = _S661 - _S654 * vec3<f32>(openness_number_0(_S650, _S658));
    var _S663 : vec3<f32> = _S661 - _S655 * vec3<f32>(openness_number_0(_S650, _S658 + u32(3)));
    var _S664 : vec3<f32> = _S661 / (_S662 * _S663 - _S654 * _S655 * vec3<f32>((_S659 * _S660)));
    (*_S656) = (_S652 * _S663 + _S654 * vec3<f32>(_S659) * _S653) * _S664;
    (*_S657) = (_S653 * _S662 + _S655 * vec3<f32>(_S660) * _S652) * _S664;
    return;
}

fn face_sends_0( _S665 : u32,  _S666 : u32,  _S667 : Scattered_0,  _S668 : Scattered_0) -> FaceSends_0
{
    var _S669 : u32 = u32(2) * _S666;
    var _S670 : u32 = u32(142) + _S669;
    var _S671 : f32 = openness_number_0(_S665, _S670);
    var _S672 : f32 = openness_number_0(_S665, _S670 + u32(1));
    var _S673 : vec3<f32> = vec3<f32>((1.0f - _S671)) * _S667.back_5;
    var _S674 : vec3<f32> = vec3<f32>((1.0f - _S672)) * _S668.back_5;
    var sends_1 : FaceSends_0;
    var _S675 : u32 = u32(154) + _S669;
    var _S676 : f32 = openness_number_0(_S665, _S675);
    sends_1.blocks_warp_0 = _S676;
    var _S677 : f32 = openness_number_0(_S665, _S675 + u32(1));
    sends_1.blocks_weft_0 = _S677;
    sends_1.open_0 = _S676 * _S671 + _S677 * _S672;
    var _S678 : vec3<f32> = vec3<f32>(_S671) * _S667.back_5;
    var _S679 : vec3<f32> = vec3<f32>(_S672) * _S668.back_5;
    var _S680 : vec3<f32> = sends_1.sky_warp_0;
    var _S681 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S665, _S666, _S678, _S679, _S673, _S674, &(_S680), &(_S681));
    sends_1.sky_warp_0 = _S680;
    sends_1.sky_weft_0 = _S681;
    var _S682 : vec3<f32> = sends_1.crossing_warp_0;
    var _S683 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S665, _S666, _S667.through_0, _S668.through_0, _S673, _S674, &(_S682), &(_S683));
    sends_1.crossing_warp_0 = _S682;
    sends_1.crossing_weft_0 = _S683;
    return sends_1;
}

fn interior_of_0( _S684 : u32,  _S685 : vec3<f32>,  _S686 : bool) -> Interior_0
{
    var _S687 : Scattered_0 = scattered_by_0(_S684, table_albedos_0(families_0[fabrics_0[_S684].warp_0].colour_mean_0), u32(0), _S685);
    var _S688 : Scattered_0 = scattered_by_0(_S684, table_albedos_0(families_0[fabrics_0[_S684].weft_0].colour_mean_0), u32(1), _S685);
    var _S689 : u32;
    if(_S686)
    {
        _S689 = u32(1);
    }
    else
    {
        _S689 = u32(0);
    }
    var _S690 : FaceSends_0 = face_sends_0(_S684, _S689, _S687, _S688);
    if(_S686)
    {
        _S689 = u32(0);
    }
    else
    {
        _S689 = u32(1);
    }
    var _S691 : FaceSends_0 = face_sends_0(_S684, _S689, _S687, _S688);
    var _S692 : vec3<f32> = vec3<f32>(_S690.blocks_warp_0);
    var _S693 : vec3<f32> = vec3<f32>(_S690.blocks_weft_0);
    var _S694 : vec3<f32> = _S692 * _S690.crossing_warp_0 + _S693 * _S690.crossing_weft_0;
    var _S695 : vec3<f32> = vec3<f32>(_S691.blocks_warp_0);
    var _S696 : vec3<f32> = vec3<f32>(_S691.blocks_weft_0);
    var _S697 : vec3<f32> = _S695 * _S691.crossing_warp_0 + _S696 * _S691.crossing_weft_0;
    var _S698 : f32 = 1.0f - _S690.open_0;
    var _S699 : f32 = 1.0f - _S691.open_0;
    var _S700 : vec3<f32> = vec3<f32>(1.0f);
    var _S701 : vec3<f32> = _S700 / (_S700 - _S694 * _S697 * vec3<f32>((_S698 * _S699)));
    var _S702 : vec3<f32> = _S697 * (vec3<f32>(_S690.open_0) + vec3<f32>(_S698) * (_S692 * _S690.sky_warp_0 + _S693 * _S690.sky_weft_0)) * _S701;
    var _S703 : vec3<f32> = _S694 * (vec3<f32>(_S691.open_0) + vec3<f32>(_S699) * (_S695 * _S691.sky_warp_0 + _S696 * _S691.sky_weft_0)) * _S701;
    var _S704 : FaceRadiance_0 = face_radiance_0(_S690, _S691.open_0, _S702, _S703);
    var _S705 : FaceRadiance_0 = face_radiance_0(_S691, _S690.open_0, _S703, _S702);
    var interior_1 : Interior_0;
    interior_1.warp_4 = _S704.warp_3;
    interior_1.weft_4 = _S704.weft_3;
    interior_1.leaked_1 = _S704.leaked_0;
    interior_1.far_1 = _S705.mean_0;
    interior_1.far_leaked_0 = _S705.leaked_0;
    return interior_1;
}

fn blocked_from_0( _S706 : u32,  _S707 : vec3<f32>,  _S708 : bool,  _S709 : bool) -> Blocked_0
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_0(_S707, &(terms_3));
    var _S710 : u32;
    if(_S709)
    {
        _S710 = u32(2);
    }
    else
    {
        _S710 = u32(0);
    }
    var _S711 : u32;
    if(_S708)
    {
        _S711 = u32(0);
    }
    else
    {
        _S711 = u32(1);
    }
    return blocked_of_terms_0(_S706, (_S710 + _S711) * u32(15), terms_3, u32(5));
}

fn warp_seen_from_0( _S712 : u32,  _S713 : vec3<f32>,  _S714 : bool) -> f32
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_1(_S713, &(terms_4));
    var term_1 : u32 = u32(0);
    var share_3 : f32 = 0.0f;
    for(;;)
    {
        if(term_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var _S715 : u32;
        if(_S714)
        {
            _S715 = u32(5);
        }
        else
        {
            _S715 = u32(0);
        }
        var share_4 : f32 = share_3 + openness_number_0(_S712, u32(132) + _S715 + term_1) * terms_4[term_1];
        term_1 = term_1 + u32(1);
        share_3 = share_4;
    }
    return saturate(share_3);
}

fn bounced_of_families_0( _S716 : u32,  _S717 : FamilyAlbedos_0,  _S718 : vec3<f32>,  _S719 : Interior_0,  _S720 : Blocked_0,  _S721 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S720, scattered_by_0(_S716, _S717.warp_5, u32(0), _S718), _S719), bounced_by_0(_S721, scattered_by_0(_S716, _S717.weft_5, u32(1), _S718), _S719));
}

fn bounced_far_0( _S722 : u32,  _S723 : FamilyAlbedos_0,  _S724 : vec3<f32>,  _S725 : Interior_0,  _S726 : vec3<f32>,  _S727 : bool,  _S728 : f32,  _S729 : f32,  _S730 : f32) -> Bounced_0
{
    var _S731 : Blocked_0 = blocked_from_0(_S722, _S726, true, _S727);
    var _S732 : Blocked_0 = blocked_from_0(_S722, _S726, false, _S727);
    var _S733 : f32 = _S728 / max(1.0f - _S731.by_warp_0 - _S731.by_weft_0, 0.10000000149011612f);
    var _S734 : f32 = (0.0020000000949949f * warp_seen_from_0(_S722, _S726, _S727) + _S733) / (_S733 + _S729 / max(1.0f - _S732.by_warp_0 - _S732.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S735 : f32 = 1.0f - _S730;
    return bounced_of_families_0(_S722, _S723, _S724, _S725, scaled_0(_S731, _S734 * _S735), scaled_0(_S732, (1.0f - _S734) * _S735));
}

fn bounced_over_0( _S736 : u32,  _S737 : Components_0,  _S738 : CloseUp_0,  _S739 : FamilyAlbedos_0,  _S740 : vec3<f32>,  _S741 : vec3<f32>) -> Bounced_0
{
    var _S742 : bool = (_S741.z) < 0.0f;
    var _S743 : Interior_0 = interior_of_0(_S736, _S740, _S742);
    var bounced_2 : Bounced_0 = bounced_far_0(_S736, _S739, _S740, _S743, to_face_frame_0(_S741, _S742), _S742, _S737.diffuse_warp_0, _S737.diffuse_weft_0, _S737.hole_2);
    if((_S738.weight_0) > 0.0f)
    {
        var _S744 : Bounced_0 = bounced_of_families_0(_S736, _S739, _S740, _S743, _S738.warp_1, _S738.weft_1);
        var _S745 : vec3<f32> = vec3<f32>(_S738.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S744.reflected_0, _S745);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S744.transmitted_0, _S745);
    }
    return bounced_2;
}

fn composed_0( _S746 : u32,  _S747 : Components_0,  _S748 : CloseUp_0,  _S749 : FamilyAlbedos_0,  _S750 : vec3<f32>,  _S751 : vec3<f32>,  _S752 : vec3<f32>) -> vec3<f32>
{
    var _S753 : Albedos_0 = tinted_0(_S749.warp_5, _S750);
    var _S754 : Albedos_0 = tinted_0(_S749.weft_5, _S750);
    var _S755 : vec3<f32> = vec3<f32>(_S747.diffuse_warp_0);
    var _S756 : vec3<f32> = vec3<f32>(_S747.diffuse_weft_0);
    var _S757 : vec3<f32> = vec3<f32>(_S747.specular_warp_0);
    var _S758 : vec3<f32> = vec3<f32>(_S747.specular_weft_0);
    var _S759 : vec3<f32> = _S753.diffuse_reflect_0 * _S755 + _S754.diffuse_reflect_0 * _S756 + _S753.specular_reflect_0 * _S757 + _S754.specular_reflect_0 * _S758;
    var _S760 : f32 = _S752.z;
    var body_0 : vec3<f32>;
    if((_S751.z * _S760) < 0.0f)
    {
        body_0 = _S753.diffuse_transmit_0 * _S755 + _S754.diffuse_transmit_0 * _S756 + _S753.specular_transmit_0 * _S757 + _S754.specular_transmit_0 * _S758;
    }
    else
    {
        body_0 = _S759;
    }
    if((fabrics_0[_S746].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S746, _S747, _S748, _S749, _S750, _S752), _S751, _S752);
    }
    var _S761 : f32 = fabrics_0[_S746].sheen_strength_0;
    if((fabrics_0[_S746].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S762 : bool = _S760 < 0.0f;
    var _S763 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S751, _S762), to_face_frame_0(_S752, _S762), _S761, fabrics_0[_S746].sheen_roughness_0);
    return vec3<f32>(_S763.y) * body_0 + vec3<f32>(((_S747.light_visibility_1 + _S747.hole_2) * _S763.x));
}

fn cloth_value_0( fabric_1 : u32,  centre_2 : vec2<f32>,  dx_1 : vec2<f32>,  dy_1 : vec2<f32>,  light_10 : vec3<f32>,  view_11 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = centre_2;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    var _S764 : Estimate_0 = lobes_estimate_0(fabric_1, footprint_0, 1.0f, light_10, view_11);
    var _S765 : vec3<f32> = composed_0(fabric_1, _S764.components_0, _S764.close_0, _S764.albedos_5, vec3<f32>(1.0f), light_10, view_11);
    var through_1 : f32;
    if((fabrics_0[fabric_1].sheen_strength_0) > 0.0f)
    {
        through_1 = _S764.components_0.hole_2 * (1.0f - fabrics_0[fabric_1].sheen_strength_0 * sheen_lobe_0(abs(view_11.z), fabrics_0[fabric_1].sheen_roughness_0).z);
    }
    else
    {
        through_1 = _S764.components_0.hole_2;
    }
    return vec4<f32>(_S765, through_1);
}

@compute
@workgroup_size(64, 1, 1)
fn lobes_queries(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S766 : u32 = id_0.x;
    if(_S766 >= query_count_0[i32(0)])
    {
        return;
    }
    var _S767 : Query_std430_0 = queries_0[_S766];
    answers_0[_S766] = cloth_value_0(_S767.fabric_0, vec2<f32>(_S767.centre_x_0, _S767.centre_y_0), vec2<f32>(_S767.dx_x_0, _S767.dx_y_0), vec2<f32>(_S767.dy_x_0, _S767.dy_y_0), vec3<f32>(_S767.light_x_0, _S767.light_y_0, _S767.light_z_0), vec3<f32>(_S767.view_x_0, _S767.view_y_0, _S767.view_z_0));
    return;
}

