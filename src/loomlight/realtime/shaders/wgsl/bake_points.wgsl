struct Bake_std430_0
{
    @align(4) fabric_0 : u32,
    @align(4) per_family_0 : u32,
    @align(4) packs_0 : u32,
    @align(4) max_clusters_0 : u32,
    @align(4) rays_0 : u32,
    @align(4) ends_0 : f32,
    @align(4) picks_0 : f32,
    @align(4) spacing_x_0 : f32,
    @align(4) spacing_y_0 : f32,
    @align(4) columns_0 : u32,
    @align(4) rows_0 : u32,
    @align(4) face_nodes_0 : u32,
    @align(4) texels_across_0 : u32,
    @align(4) texels_along_0 : u32,
    @align(4) texel_x_0 : f32,
    @align(4) texel_y_0 : f32,
    @align(4) far_weight_0 : f32,
    @align(4) moments_table_0 : u32,
    @align(4) record_warp_packs_0 : u32,
    @align(4) record_hole_weights_0 : u32,
    @align(4) facts_0 : u32,
    @align(4) gaps_0 : u32,
    @align(4) gap_nulls_0 : u32,
    @align(4) lit_0 : u32,
    @align(4) lists_0 : u32,
    @align(4) points_0 : u32,
    @align(4) clusters_0 : u32,
    @align(4) cluster_means_0 : u32,
    @align(4) cluster_errors_0 : u32,
    @align(4) centroids_0 : u32,
    @align(4) view_sums_0 : u32,
    @align(4) light_sums_0 : u32,
    @align(4) group_moments_0 : u32,
    @align(4) areas_0 : u32,
    @align(4) area_scales_0 : u32,
    @align(4) stand_ins_0 : u32,
    @align(4) row_totals_0 : u32,
    @align(4) row_largest_0 : u32,
    @align(4) coverage_means_0 : u32,
    @align(4) coverage_scales_0 : u32,
    @align(4) hole_bytes_0 : u32,
};

@binding(11) @group(0) var<storage, read> bakes_0 : array<Bake_std430_0>;

struct SurfaceHit_std430_0
{
    @align(4) place_x_0 : f32,
    @align(4) place_y_0 : f32,
    @align(4) place_z_0 : f32,
    @align(4) flags_0 : u32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) tangent_x_0 : f32,
    @align(4) tangent_y_0 : f32,
    @align(4) tangent_z_0 : f32,
    @align(4) shown_share_0 : f32,
};

@binding(13) @group(0) var<storage, read_write> hits_0 : array<SurfaceHit_std430_0>;

@binding(14) @group(0) var<storage, read_write> scratch_0 : array<u32>;

var<workgroup> offsets_0 : array<u32, i32(256)>;

fn sample_index_0( _S1 : i32,  _S2 : u32,  _S3 : bool,  _S4 : u32) -> u32
{
    var _S5 : u32 = _S2 % u32(4) / u32(2);
    if(_S3)
    {
        return (_S5 * u32(256) + _S4 / u32(32)) * bakes_0[_S1].rays_0 + _S4 % u32(32) * (bakes_0[_S1].rays_0 / u32(32));
    }
    return u32(512) * bakes_0[_S1].rays_0 + _S5 * u32(8192) + _S4;
}

fn is_member_0( _S6 : i32,  _S7 : ptr<function, SurfaceHit_std430_0>,  _S8 : u32,  _S9 : bool) -> bool
{
    var _S10 : u32 = (*_S7).flags_0;
    var _S11 : bool = ((((((*_S7).flags_0) & (u32(2)))) != u32(0)) | (((_S9 & ((((((*_S7).flags_0) & (u32(4)))) != u32(0)))))));
    if(_S8 == u32(4))
    {
        return _S11;
    }
    return ((!_S11) & (((((_S10 & (u32(1)))) != u32(0)) == ((_S8 % u32(2)) == u32(0)))));
}

fn compact_0( _S12 : i32,  _S13 : u32,  _S14 : u32,  _S15 : bool) -> u32
{
    var _S16 : u32 = select(u32(8192), u32(8192), _S15) / u32(256);
    var i_0 : u32 = u32(0);
    var count_0 : u32 = u32(0);
    for(;;)
    {
        if(i_0 < _S16)
        {
        }
        else
        {
            break;
        }
        var _S17 : SurfaceHit_std430_0 = hits_0[sample_index_0(_S12, _S13, _S15, _S14 * _S16 + i_0)];
        var _S18 : bool = is_member_0(_S12, &(_S17), _S13, _S15);
        var count_1 : u32 = count_0 + select(u32(0), u32(1), _S18);
        i_0 = i_0 + u32(1);
        count_0 = count_1;
    }
    offsets_0[_S14] = count_0;
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    var other_0 : u32 = u32(0);
    var before_0 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(other_0 < u32(256))
        {
        }
        else
        {
            break;
        }
        var before_1 : u32 = before_0 + select(u32(0), offsets_0[other_0], other_0 < _S14);
        var total_1 : u32 = total_0 + offsets_0[other_0];
        other_0 = other_0 + u32(1);
        before_0 = before_1;
        total_0 = total_1;
    }
    i_0 = u32(0);
    for(;;)
    {
        if(i_0 < _S16)
        {
        }
        else
        {
            break;
        }
        var _S19 : u32 = sample_index_0(_S12, _S13, _S15, _S14 * _S16 + i_0);
        var _S20 : SurfaceHit_std430_0 = hits_0[_S19];
        var _S21 : bool = is_member_0(_S12, &(_S20), _S13, _S15);
        if(_S21)
        {
            scratch_0[bakes_0[_S12].lists_0 + _S13 * u32(8192) + before_0] = _S19;
            before_0 = before_0 + u32(1);
        }
        i_0 = i_0 + u32(1);
    }
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    return total_0;
}

@compute
@workgroup_size(256, 1, 1)
fn bake_gaps(@builtin(local_invocation_id) thread_0 : vec3<u32>)
{
    var _S22 : u32 = thread_0.x;
    var _S23 : u32 = compact_0(i32(0), u32(4), _S22, false);
    var _S24 : u32 = max(_S23 / u32(128), u32(1));
    var _S25 : u32 = (_S23 + _S24 - u32(1)) / _S24;
    var _S26 : u32 = min(_S25, u32(128));
    var i_1 : u32 = _S22;
    for(;;)
    {
        if(i_1 < _S26)
        {
        }
        else
        {
            break;
        }
        var _S27 : SurfaceHit_std430_0 = hits_0[scratch_0[bakes_0[i32(0)].lists_0 + u32(32768) + i_1 * _S24]];
        var _S28 : u32 = bakes_0[i32(0)].gaps_0 + u32(2) * i_1;
        scratch_0[_S28] = (bitcast<u32>((hits_0[scratch_0[bakes_0[i32(0)].lists_0 + u32(32768) + i_1 * _S24]].place_x_0)));
        scratch_0[_S28 + u32(1)] = (bitcast<u32>((_S27.place_y_0)));
        i_1 = i_1 + u32(256);
    }
    if(_S22 == u32(0))
    {
        var _S29 : u32 = bakes_0[i32(0)].facts_0;
        scratch_0[bakes_0[i32(0)].facts_0 + u32(8)] = _S23;
        scratch_0[_S29 + u32(9)] = _S26;
    }
    return;
}

fn thinned_0( number_0 : u32,  size_0 : u32) -> u32
{
    if(size_0 <= u32(2048))
    {
        return min(number_0, max(size_0, u32(1)) - u32(1));
    }
    var _S30 : u32 = number_0 * u32(2654435769);
    return ((((_S30 >> (u32(16)))) * size_0 + (((((_S30 & (u32(65535)))) * size_0) >> (u32(16))))) >> (u32(16)));
}

fn hit_normal_0( hit_0 : ptr<function, SurfaceHit_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*hit_0).normal_x_0, (*hit_0).normal_y_0, (*hit_0).normal_z_0);
}

fn hit_tangent_0( hit_1 : ptr<function, SurfaceHit_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*hit_1).tangent_x_0, (*hit_1).tangent_y_0, (*hit_1).tangent_z_0);
}

fn point_row_0( _S31 : i32,  _S32 : u32,  _S33 : u32) -> u32
{
    return bakes_0[_S31].points_0 + (_S32 * u32(2048) + _S33) * u32(7);
}

@compute
@workgroup_size(256, 1, 1)
fn bake_points(@builtin(workgroup_id) group_0 : vec3<u32>, @builtin(local_invocation_id) thread_1 : vec3<u32>)
{
    var _S34 : u32 = group_0.x;
    var _S35 : u32 = thread_1.x;
    var _S36 : u32 = bakes_0[i32(0)].lists_0 + _S34 * u32(8192);
    var _S37 : u32 = compact_0(i32(0), _S34, _S35, false);
    var from_top_0 : array<u32, i32(8)>;
    var i_2 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < u32(8))
        {
        }
        else
        {
            break;
        }
        from_top_0[i_2] = scratch_0[_S36 + thinned_0(_S35 * u32(8) + i_2, _S37)];
        i_2 = i_2 + u32(1);
    }
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    var _S38 : u32 = compact_0(i32(0), _S34, _S35, true);
    var _S39 : bool = ((_S37 > u32(0)) & ((_S38 >= u32(64))));
    var _S40 : u32 = select(_S37, _S38, _S39);
    i_2 = u32(0);
    for(;;)
    {
        if(i_2 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S41 : u32 = _S35 * u32(8) + i_2;
        if(_S41 < _S40)
        {
            var _S42 : u32;
            if(_S39)
            {
                _S42 = scratch_0[_S36 + thinned_0(_S41, _S38)];
            }
            else
            {
                _S42 = from_top_0[i_2];
            }
            var _S43 : SurfaceHit_std430_0 = hits_0[_S42];
            var _S44 : u32 = point_row_0(i32(0), _S34, _S41);
            var _S45 : vec3<f32> = hit_normal_0(&(_S43));
            var _S46 : vec3<f32> = vec3<f32>(10000.0f);
            var _S47 : vec3<f32> = round(vec3<f32>(0.5f) * _S45 * _S46);
            var _S48 : vec3<f32> = hit_tangent_0(&(_S43));
            var _S49 : vec3<f32> = round(_S48 * _S46);
            var k_0 : u32 = u32(0);
            for(;;)
            {
                if(k_0 < u32(3))
                {
                }
                else
                {
                    break;
                }
                scratch_0[_S44 + k_0] = (bitcast<u32>((_S47[k_0])));
                scratch_0[_S44 + u32(3) + k_0] = (bitcast<u32>((_S49[k_0])));
                k_0 = k_0 + u32(1);
            }
            scratch_0[_S44 + u32(6)] = (bitcast<u32>((round(2.0f * _S43.shown_share_0 * 10000.0f))));
        }
        i_2 = i_2 + u32(1);
    }
    if(_S35 == u32(0))
    {
        var _S50 : u32 = bakes_0[i32(0)].facts_0;
        scratch_0[bakes_0[i32(0)].facts_0 + _S34] = _S38;
        scratch_0[_S50 + u32(4) + _S34] = min(_S40, u32(2048));
    }
    return;
}

