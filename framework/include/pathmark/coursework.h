// The whole coursework API: the one header that a coursework file includes.
//
//   types.h          points, directions, colours, rays, samples
//   sampler.h        random numbers
//   frame.h          an orthonormal frame around a normal
//   warmup.h         part 0: path tracing in a triangle mesh
//   camera.h         part 1: SimpleCamera
//   shapes.h         parts 2 and 9: Polygon, Sphere
//   brdf.h           parts 3 and 4: lambertianBRDF, phongBRDF
//   lit_scene.h      parts 1, 2, 5, 6 and 8: LitScene, Hit, Light
//   unimplemented.h  the marker of an unwritten function
#pragma once

#include <pathmark/brdf.h>
#include <pathmark/camera.h>
#include <pathmark/frame.h>
#include <pathmark/lit_scene.h>
#include <pathmark/sampler.h>
#include <pathmark/shapes.h>
#include <pathmark/types.h>
#include <pathmark/unimplemented.h>
#include <pathmark/warmup.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
