# Draws what jobs.json lists, each lit by an even sky and a sun, as pictures.
extends SceneTree

func _initialize():
	for job in JSON.parse_string(FileAccess.get_file_as_string("res://jobs.json")):
		await draw(job)
	quit()

func draw(job):
	var view = SubViewport.new()
	view.size = Vector2i(job.side, job.side)
	view.own_world_3d = true
	view.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(view)
	var cloth = MeshInstance3D.new()
	cloth.mesh = load("res://mesh.obj")
	cloth.material_override = load("res://" + job.file).duplicate()
	cloth.material_override.uv1_scale *= job.metres
	view.add_child(cloth)
	view.add_child(sky_of(job.sky))
	if job.sun > 0:
		var sun = DirectionalLight3D.new()
		sun.light_energy = job.sun / PI
		view.add_child(sun)
		sun.look_at_from_position(vector(job.toSun), Vector3.ZERO)
	var camera = Camera3D.new()
	camera.fov = job.degrees
	camera.near = 0.01
	view.add_child(camera)
	camera.look_at_from_position(vector(job.eye), Vector3.ZERO)
	for frame in 8:
		await process_frame
	await RenderingServer.frame_post_draw
	view.get_texture().get_image().save_png("res://" + job.picture)
	view.queue_free()

func vector(numbers):
	return Vector3(numbers[0], numbers[1], numbers[2])

func sky_of(radiance):
	var image = Image.create(16, 8, false, Image.FORMAT_RGBF)
	image.fill(Color(radiance, radiance, radiance))
	var material = PanoramaSkyMaterial.new()
	material.panorama = ImageTexture.create_from_image(image)
	var environment = Environment.new()
	environment.sky = Sky.new()
	environment.sky.sky_material = material
	environment.background_mode = Environment.BG_SKY
	environment.ambient_light_source = Environment.AMBIENT_SOURCE_SKY
	environment.reflected_light_source = Environment.REFLECTION_SOURCE_SKY
	environment.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	var world = WorldEnvironment.new()
	world.environment = environment
	return world
