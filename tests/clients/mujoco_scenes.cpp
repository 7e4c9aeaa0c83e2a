#include "clients/mujoco_scenes.h"

#include <cstdio>

namespace softgl::test {
namespace {

// A floor that reflects under a sky, with a checkered texture, and one of each primitive above it.
constexpr char kPrimitives[] =
    R"(<mujoco><visual><global offwidth="400" offheight="300"/><quality shadowsize="1024"/>
  <headlight ambient=".2 .2 .2" diffuse=".4 .4 .4"/></visual><asset>
  <texture name="sky" type="skybox" builtin="gradient" rgb1=".3 .5 .7" rgb2="0 0 0" width="128" height="768"/>
  <texture name="checker" type="2d" builtin="checker" rgb1=".1 .2 .3" rgb2=".8 .7 .6" width="256" height="256"/>
  <texture name="cube" type="cube" builtin="flat" mark="cross" markrgb="1 1 1" rgb1=".8 .3 .2" rgb2=".3 .8 .2" width="64" height="64"/>
  <material name="floor" texture="checker" texrepeat="6 6" reflectance=".4"/>
  <material name="cube" texture="cube" shininess=".6" specular=".7"/>
  <material name="shiny" rgba=".2 .6 .9 1" shininess=".9" specular="1"/>
  <material name="glow" rgba=".9 .8 .2 1" emission=".4"/>
  <material name="glass" rgba=".4 .9 .6 .5"/></asset><worldbody>
  <light pos="0 0 4" dir="0 0 -1" diffuse=".8 .8 .8" specular=".4 .4 .4"/>
  <light pos="3 -3 5" dir="-1 1 -2" directional="true" diffuse=".3 .3 .4"/>
  <geom type="plane" size="3 3 .1" material="floor"/>
  <body pos="-1 0 .5"><freejoint/><geom type="box" size=".3 .4 .3" material="cube"/></body>
  <body pos="0 -.8 .6"><freejoint/><geom type="sphere" size=".35" material="shiny"/></body>
  <body pos="1 .3 .8"><freejoint/><geom type="capsule" size=".2 .4" material="glow" euler="20 30 0"/></body>
  <body pos="-.2 1 .7"><freejoint/><geom type="cylinder" size=".3 .3" material="glass" euler="40 0 10"/></body>
  <body pos=".9 -1 .6"><freejoint/><geom type="ellipsoid" size=".4 .2 .3" material="cube"/></body>
  </worldbody></mujoco>)";

// A figure of capsules with joints, tendons, motors and sensors: much to decorate.
constexpr char kFigure[] =
    R"(<mujoco><visual><global offwidth="400" offheight="300"/><quality shadowsize="2048"/></visual><asset>
  <texture name="sky" type="skybox" builtin="gradient" rgb1="1 1 1" rgb2=".6 .8 1" width="256" height="256"/>
  <texture name="floor" type="2d" builtin="checker" rgb1=".2 .3 .4" rgb2=".1 .15 .2" width="300" height="300" mark="edge" markrgb=".8 .8 .8"/>
  <texture name="skin" type="cube" builtin="flat" rgb1=".8 .6 .4" rgb2=".8 .6 .4" mark="random" markrgb="1 1 1" random=".05" width="127" height="127"/>
  <material name="floor" texture="floor" texuniform="true" reflectance=".2"/><material name="skin" texture="skin" texuniform="true"/></asset>
  <default><geom material="skin" condim="3" friction=".7"/><joint damping=".5" limited="true" range="-60 60"/></default><worldbody>
  <light pos="0 0 5" dir="0 0 -1" castshadow="true"/><camera name="side" pos="0 -3 1.2" euler="80 0 0"/>
  <geom type="plane" size="20 20 .1" material="floor" condim="3"/>
  <body name="torso" pos="0 0 1.4"><freejoint/><geom type="capsule" fromto="0 -.07 0 0 .07 0" size=".07"/><geom type="sphere" pos="0 0 .19" size=".09"/>
   <geom type="capsule" fromto="-.01 -.06 -.12 -.01 .06 -.12" size=".06"/><site name="torso" pos="0 0 .05" size=".03" rgba="1 0 0 .6"/>
   <body pos="-.01 0 -.26"><joint type="hinge" axis="0 1 0"/><geom type="capsule" fromto="0 -.06 0 0 .06 0" size=".06"/>
    <body pos="0 -.1 -.1"><joint name="right_hip" type="hinge" axis="0 1 0" range="-110 20"/><geom type="capsule" fromto="0 0 0 0 .01 -.34" size=".06"/>
     <body pos="0 .01 -.403"><joint name="right_knee" type="hinge" axis="0 -1 0" range="-160 -2"/><geom type="capsule" fromto="0 0 0 0 0 -.3" size=".049"/>
      <body pos="0 0 -.39"><joint type="hinge" axis="0 1 0"/><geom type="capsule" fromto="-.07 -.02 0 .14 -.04 0" size=".027"/></body></body></body>
    <body pos="0 .1 -.1"><joint name="left_hip" type="hinge" axis="0 1 0" range="-110 20"/><geom type="capsule" fromto="0 0 0 0 -.01 -.34" size=".06"/>
     <body pos="0 -.01 -.403"><joint name="left_knee" type="hinge" axis="0 -1 0" range="-160 -2"/><geom type="capsule" fromto="0 0 0 0 0 -.3" size=".049"/>
      <body pos="0 0 -.39"><joint type="hinge" axis="0 1 0"/><geom type="capsule" fromto="-.07 .02 0 .14 .04 0" size=".027"/></body></body></body></body>
   <body pos="0 -.17 .06"><joint type="hinge" axis="2 1 1"/><geom type="capsule" fromto="0 0 0 .16 -.16 -.16" size=".04"/><site name="right" pos=".16 -.16 -.16" size=".02"/></body>
   <body pos="0 .17 .06"><joint type="hinge" axis="2 -1 1"/><geom type="capsule" fromto="0 0 0 .16 .16 -.16" size=".04"/><site name="left" pos=".16 .16 -.16" size=".02"/></body></body>
  </worldbody><tendon><spatial name="string" width=".01" rgba=".9 .2 .9 1"><site site="left"/><site site="torso"/><site site="right"/></spatial></tendon>
  <actuator><motor joint="right_hip" gear="40"/><motor joint="left_hip" gear="40"/></actuator>
  <sensor><accelerometer site="torso"/><touch site="torso"/></sensor></mujoco>)";

// A height field below a mesh and boxes, with a spot light.
constexpr char kHeightField[] =
    R"(<mujoco><visual><global offwidth="400" offheight="300"/><quality shadowsize="512"/><map fogstart="2" fogend="8"/><rgba fog=".7 .8 .9 1" haze=".9 .9 1 1"/></visual><asset>
  <texture name="ground" type="2d" builtin="gradient" rgb1=".2 .5 .2" rgb2=".6 .5 .3" width="64" height="64" mark="random" markrgb="0 0 0" random=".1"/>
  <texture name="sky" type="skybox" builtin="gradient" rgb1=".4 .6 .8" rgb2=".9 .9 1" width="100" height="100"/>
  <material name="ground" texture="ground" texrepeat="3 3"/>
  <hfield name="hills" nrow="24" ncol="32" size="2 2 .5 .1"/>
  <mesh name="wedge" vertex="0 0 0  1 0 0  0 1 0  1 1 0  0 0 1  1 0 1" scale=".6 .6 .6"/></asset><worldbody>
  <light pos="0 -2 4" dir="0 .5 -1" cutoff="30" exponent="6" diffuse="1 1 .9"/>
  <geom type="hfield" hfield="hills" material="ground"/>
  <body pos="0 0 1.2"><freejoint/><geom type="mesh" mesh="wedge" rgba=".8 .3 .3 1"/></body>
  <body pos="-.8 .5 1.5"><freejoint/><geom type="box" size=".2 .2 .2" rgba=".3 .3 .8 1"/></body>
  </worldbody></mujoco>)";

void nothing(mjvOption&, mjvScene&) {}
void no_overlay(mjrRect, mjrContext&) {}

void segments(mjvOption&, mjvScene& view) { view.flags[mjRND_SEGMENT] = view.flags[mjRND_IDCOLOR] = 1; }
void wireframe(mjvOption&, mjvScene& view) { view.flags[mjRND_WIREFRAME] = 1; }
void fog(mjvOption&, mjvScene& view) { view.flags[mjRND_FOG] = view.flags[mjRND_HAZE] = 1; }
void additive(mjvOption& option, mjvScene& view) {
  view.flags[mjRND_ADDITIVE] = 1;
  option.flags[mjVIS_TRANSPARENT] = 1;
}
void plain(mjvOption&, mjvScene& view) {
  view.flags[mjRND_SHADOW] = view.flags[mjRND_REFLECTION] = view.flags[mjRND_SKYBOX] = 0;
}

void decorations(mjvOption& option, mjvScene&) {
  for (const int flag :
       {mjVIS_JOINT, mjVIS_ACTUATOR, mjVIS_LIGHT, mjVIS_CAMERA, mjVIS_TENDON, mjVIS_CONTACTPOINT,
        mjVIS_CONTACTFORCE, mjVIS_COM, mjVIS_INERTIA, mjVIS_AUTOCONNECT, mjVIS_CONSTRAINT})
    option.flags[flag] = 1;
  option.label = mjLABEL_BODY;
  option.frame = mjFRAME_BODY;
}

void words(mjrRect viewport, mjrContext& context) {
  mjr_overlay(mjFONT_NORMAL, mjGRID_TOPLEFT, viewport, "Time\nSteps\nBodies", "0.25\n125\n6", &context);
  mjr_overlay(mjFONT_BIG, mjGRID_BOTTOMRIGHT, viewport, "Big letters", nullptr, &context);
  mjr_text(mjFONT_SHADOW, "with a shadow", &context, .1F, .3F, 1, .8F, .2F);
  mjr_rectangle({20, 120, 90, 40}, .2F, .3F, .9F, .6F);
  mjr_label({250, 220, 120, 30}, mjFONT_NORMAL, "label", .5F, .1F, .1F, .8F, 1, 1, 1, &context);
  mjvFigure figure;
  mjv_defaultFigure(&figure);
  std::snprintf(figure.title, sizeof figure.title, "A figure");
  std::snprintf(figure.xlabel, sizeof figure.xlabel, "time");
  figure.flg_legend = 1;
  for (int line = 0; line < 3; ++line) {
    std::snprintf(figure.linename[line], sizeof figure.linename[line], "line %d", line);
    figure.linepnt[line] = 50;
    for (int point = 0; point < 50; ++point) {
      figure.linedata[line][2 * point] = float(point);
      figure.linedata[line][2 * point + 1] = float((point * (line + 3)) % 20) * float(line - 1);
    }
  }
  mjr_figure({200, 0, 200, 150}, &figure, &context);
}

constexpr MujocoScene kScenes[] = {
    {"primitives", kPrimitives, 50, 0, 1, false, nothing, no_overlay},
    {"window", kPrimitives, 50, 0, 1, true, nothing, no_overlay},
    {"multisampled", kPrimitives, 50, 4, 1, false, nothing, no_overlay},
    {"plain", kPrimitives, 0, 0, .8, false, plain, no_overlay},
    {"segments", kPrimitives, 50, 0, 1, false, segments, no_overlay},
    {"wireframe", kPrimitives, 50, 0, 1, false, wireframe, no_overlay},
    {"additive", kPrimitives, 50, 0, 1, false, additive, no_overlay},
    {"words", kPrimitives, 20, 0, 1.2, false, nothing, words},
    {"figure", kFigure, 0, 0, .3, false, nothing, no_overlay},
    {"figure_falls", kFigure, 300, 0, .3, false, nothing, no_overlay},
    {"decorations", kFigure, 300, 0, .25, false, decorations, no_overlay},
    {"height_field", kHeightField, 100, 0, 1, false, nothing, no_overlay},
    {"fog", kHeightField, 100, 0, 1, false, fog, no_overlay},
};

} // namespace

std::span<const MujocoScene> mujoco_scenes() { return kScenes; }

} // namespace softgl::test
