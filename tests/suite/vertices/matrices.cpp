// The matrices, their stacks, the viewport and the depth range (2.11).
#include "lighting/scenes.h"
#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {
namespace {

constexpr Need kTranspose{13, "GL_ARB_transpose_matrix"};
// Moves, turns and scales; not symmetric. Column after column.
const V kMatrix = {0.8, 0.5, 0, 0, -0.4, 1.1, 0, 0, 0, 0, 1, 0, 0.2, -0.3, 0, 1};
const V kTransposedMatrix = {0.8, -0.4, 0, 0.2, 0.5, 1.1, 0, -0.3, 0, 0, 1, 0, 0, 0, 0, 1};
const V kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Test turned(const char* name, const char* sentence, double angle, double x, double y, double z) {
  return row(name, "2.11.2", sentence, [=](Script& s) {
    perspective(s), s.Scalef(1.7, 1.7, 1.7), s.Rotatef(angle, x, y, z), arrow(s);
  });
}

} // namespace

std::vector<Test> vertices_matrix_tests() {
  return {
      row("matrices.translate", "2.11.2", "glTranslate moves what is drawn.",
          [](Script& s) { s.Translatef(0.4, -0.5, 0), arrow(s), s.Translated(-0.8, 0.9, 0), arrow(s); }),
      row("matrices.scale", "2.11.2", "glScale scales each axis.",
          [](Script& s) { s.Scalef(2, 0.5, 1), arrow(s), s.Scaled(0.25, 3.5, 1), arrow(s); }),
      turned("matrices.rotate_x", "glRotate turns about the x axis.", 50, 1, 0, 0),
      turned("matrices.rotate_y", "glRotate turns about the y axis.", 50, 0, 1, 0),
      turned("matrices.rotate_z", "glRotate turns about the z axis, counterclockwise seen from +z.", 50, 0, 0,
             1),
      turned("matrices.rotate_negative", "A negative angle turns the other way.", -35, 0, 0, 1),
      turned("matrices.rotate_axis", "glRotate turns about any axis.", 70, 1, -2, 3),
      turned("matrices.rotate_long_axis", "The length of the axis does not matter.", 70, 10, -20, 30),
      turned("matrices.rotate_short_axis", "A short axis is normalized like any other.", 70, 0.01, -0.02,
             0.03),
      turned("matrices.rotate_round", "A turn of more than 360 degrees is what is left of it.", 410, 0.6, 0,
             0.8),
      row("matrices.rotated", "2.11.2", "glRotated turns as glRotatef.",
          [](Script& s) { s.Scalef(1.7, 1.7, 1), s.Rotated(130, 0, 0, 1), arrow(s); }),
      row("matrices.order", "2.11.2", "What is multiplied last is applied to the vertex first.",
          [](Script& s) {
            s.PushMatrix(), s.Translatef(0.6, 0, 0), s.Rotatef(90, 0, 0, 1), arrow(s), s.PopMatrix();
            s.Rotatef(90, 0, 0, 1), s.Translatef(0.6, 0, 0), arrow(s);
          }),
      row("matrices.load", "2.11.2", "glLoadMatrix takes a matrix column after column.",
          [](Script& s) {
            V m = kMatrix;
            m[14] = -5;
            s.LoadMatrixf(m), arrow(s), m[12] = -0.5, m[13] = 0.6, s.LoadMatrixd(m), arrow(s);
          }),
      row("matrices.multiply", "2.11.2", "glMultMatrix multiplies from the right.",
          [](Script& s) {
            s.Rotatef(70, 0, 0, 1), s.MultMatrixf(kMatrix), arrow(s), s.MultMatrixd(kMatrix),
                s.Translatef(0, 0.8, 0), arrow(s);
          }),
      row(
          "matrices.load_transpose", "2.11.2", "glLoadTransposeMatrix takes a matrix row after row.",
          [](Script& s) {
            V m = kTransposedMatrix;
            m[11] = -5;
            s.LoadTransposeMatrixf(m), arrow(s), m[3] = -0.5, m[7] = 0.6, s.LoadTransposeMatrixd(m), arrow(s);
          },
          kTranspose),
      row(
          "matrices.multiply_transpose", "2.11.2",
          "glMultTransposeMatrix multiplies by the matrix row after row.",
          [](Script& s) {
            s.Rotatef(70, 0, 0, 1), s.MultTransposeMatrixf(kTransposedMatrix), arrow(s),
                s.MultTransposeMatrixd(kTransposedMatrix);
            s.Translatef(0, 0.8, 0), arrow(s);
          },
          kTranspose),
      row("matrices.load_identity", "2.11.2", "glLoadIdentity undoes all before it.",
          [](Script& s) { s.MultMatrixf(kMatrix), s.LoadIdentity(), s.Translatef(0, 0, -3), arrow(s); }),
      row("matrices.frustum", "2.11.2", "glFrustum is a perspective that need not be symmetric.",
          [](Script& s) {
            s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Frustum(-0.1, 0.3, -0.25, 0.15, 0.8, 12),
                s.MatrixMode(GL_MODELVIEW);
            s.Translatef(0.4, -0.2, 1), s.Rotatef(40, 1, 0.5, 0), s.Scalef(1.5, 1.5, 1.5), arrow(s);
          }),
      row("matrices.ortho", "2.11.2", "glOrtho maps its box to the viewport.",
          [](Script& s) {
            s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Ortho(-0.5, 0.7, -0.9, 0.6, 4, 6),
                s.MatrixMode(GL_MODELVIEW), arrow(s);
          }),
      row("matrices.ortho_mirrored", "2.11.2", "A box whose left is greater than its right mirrors.",
          [](Script& s) {
            s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Ortho(0.7, -0.7, 0.9, -0.6, 4, 6),
                s.MatrixMode(GL_MODELVIEW), arrow(s);
          }),
      row("matrices.projection_multiplies", "2.11.2",
          "glFrustum and glOrtho multiply the matrix that is there.",
          [](Script& s) {
            s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Scalef(0.6, 0.7, 1), s.Translatef(0.2, -0.3, 0);
            s.Frustum(-0.2, 0.2, -0.2, 0.2, 1, 12), s.MatrixMode(GL_MODELVIEW), s.Scalef(1.5, 1.5, 1),
                arrow(s);
            s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Scalef(0.3, 0.4, 1), s.Translatef(-1.6, 0.9, 0);
            s.Ortho(-0.5, 0.7, -0.9, 0.6, 4, 6), s.MatrixMode(GL_MODELVIEW), arrow(s);
          }),
      row("matrices.modelview_stack", "2.11.2", "glPopMatrix brings back the matrix of its glPushMatrix.",
          [](Script& s) {
            s.PushMatrix(), s.Translatef(-0.5, -0.5, 0), s.PushMatrix(), s.Rotatef(90, 0, 0, 1), arrow(s),
                s.PopMatrix();
            s.Translatef(1, 0, 0), arrow(s), s.PopMatrix(), s.Translatef(0, 0.6, 0), arrow(s);
          }),
      row("matrices.stack_depth", "2.11.2", "The stack of modelview matrices holds at least 32.",
          [](Script& s) {
            for (int i = 0; i < 31; i++) s.PushMatrix(), s.Translatef(0.02, 0.01, 0);
            s.GetFloatv(GL_MODELVIEW_STACK_DEPTH, V{32});
            arrow(s);
            for (int i = 0; i < 31; i++) s.PopMatrix();
            s.GetFloatv(GL_MODELVIEW_STACK_DEPTH, V{1});
            s.Translatef(-0.6, -0.6, 0), arrow(s);
          }),
      row("matrices.projection_stack", "2.11.2", "The stack of projections holds at least two.",
          [](Script& s) {
            s.MatrixMode(GL_PROJECTION), s.PushMatrix(), s.Scalef(0.5, 0.5, 1), s.MatrixMode(GL_MODELVIEW),
                arrow(s);
            s.MatrixMode(GL_PROJECTION), s.GetFloatv(GL_PROJECTION_STACK_DEPTH, V{2}), s.PopMatrix(),
                s.MatrixMode(GL_MODELVIEW);
            s.Translatef(0.6, 0.5, 0), arrow(s);
          }),
      row("matrices.texture_stack", "2.11.2", "The texture matrix has a stack of its own.",
          [](Script& s) {
            s.MatrixMode(GL_TEXTURE), s.GetFloatv(GL_TEXTURE_MATRIX, kIdentity), s.MultMatrixf(kMatrix),
                s.PushMatrix();
            s.LoadIdentity(), s.GetFloatv(GL_TEXTURE_STACK_DEPTH, V{2}),
                s.GetFloatv(GL_TEXTURE_MATRIX, kIdentity), s.PopMatrix();
            s.GetFloatv(GL_TEXTURE_MATRIX, kMatrix), s.GetFloatv(GL_TEXTURE_STACK_DEPTH, V{1});
            s.MatrixMode(GL_MODELVIEW), arrow(s);
          }),
      row("matrices.mode", "2.11.2", "A matrix command works on the matrix of the mode only.",
          [](Script& s) {
            s.MatrixMode(GL_TEXTURE), s.Scalef(9, 9, 9), s.MatrixMode(GL_PROJECTION), s.Scalef(0.5, 1, 1);
            s.MatrixMode(GL_MODELVIEW), s.Scalef(2, 1.5, 1), arrow(s);
          }),
      row("matrices.queried", "2.11.2, table 6.7", "Matrices and the mode can be asked for.",
          [](Script& s) {
            s.GetFloatv(GL_MATRIX_MODE, V{double(GL_MODELVIEW)}), s.LoadIdentity(),
                s.GetFloatv(GL_MODELVIEW_MATRIX, kIdentity);
            s.Translatef(1, 2, 3),
                s.GetFloatv(GL_MODELVIEW_MATRIX, V{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1});
            s.Rotatef(90, 0, 0, 1),
                s.GetFloatv(GL_MODELVIEW_MATRIX, V{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1});
            s.LoadMatrixf(kMatrix), s.Scalef(2, 4, 8);
            s.GetFloatv(GL_MODELVIEW_MATRIX, V{1.6, 1, 0, 0, -1.6, 4.4, 0, 0, 0, 0, 8, 0, 0.2, -0.3, 0, 1});
            s.MatrixMode(GL_PROJECTION), s.GetFloatv(GL_MATRIX_MODE, V{double(GL_PROJECTION)}),
                s.LoadIdentity();
            s.Frustum(-1, 3, -2, 2, 1, 3);
            s.GetFloatv(GL_PROJECTION_MATRIX, V{0.5, 0, 0, 0, 0, 0.5, 0, 0, 0.5, 0, -2, -1, 0, 0, -3, 0});
            s.LoadIdentity(), s.Ortho(-1, 3, -2, 2, 1, 3);
            s.GetFloatv(GL_PROJECTION_MATRIX, V{0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, -1, 0, -0.5, 0, -2, 1});
          }),
      row("matrices.saved_mode", "6.1.14, table 6.7",
          "GL_TRANSFORM_BIT saves the matrix mode, and no matrix.",
          [](Script& s) {
            s.PushAttrib(GL_TRANSFORM_BIT), s.Scalef(0.5, 0.5, 1), s.MatrixMode(GL_PROJECTION), s.PopAttrib();
            s.GetFloatv(GL_MATRIX_MODE, V{double(GL_MODELVIEW)}), s.Translatef(0.7, 0.4, 0), arrow(s);
          }),
      row("matrices.viewport", "2.11.1", "The viewport is where the view volume comes out.",
          [](Script& s) { s.Viewport(10, 40, 80, 30), arrow(s), s.Viewport(50, 5, 30, 80), arrow(s); }),
      row("matrices.viewport_outside", "2.11.1", "A viewport may reach beyond the window.",
          [](Script& s) {
            s.Viewport(-60, -20, 200, 150), arrow(s), s.Viewport(20, 30, 150, 120), arrow(s);
          }),
      row("matrices.viewport_clamped", "2.11.1", "A viewport is clamped to GL_MAX_VIEWPORT_DIMS.",
          [](Script& s) {
            s.Viewport(0, 0, 1000000000, 1000000000),
                s.PaintEqual(GL_VIEWPORT, 2, GL_MAX_VIEWPORT_DIMS, 0, 4, 84);
            s.PaintEqual(GL_VIEWPORT, 3, GL_MAX_VIEWPORT_DIMS, 1, 14, 84), s.Viewport(0, 0, 96, 96), arrow(s);
          }),
      row("matrices.viewport_saved", "6.1.14, table 6.7",
          "GL_VIEWPORT_BIT saves the viewport and the depth range.",
          [](Script& s) {
            s.PushAttrib(GL_VIEWPORT_BIT), s.Viewport(3, 4, 20, 20), s.DepthRange(0.5, 0.7), s.PopAttrib();
            s.GetFloatv(GL_VIEWPORT, V{0, 0, 96, 96}), s.GetFloatv(GL_DEPTH_RANGE, V{0, 1}), arrow(s);
          }),
      row("matrices.depth_range", "2.11.1", "The depth range maps the depths of the volume.",
          [](Script& s) {
            s.Enable(GL_DEPTH_TEST), s.DepthRange(0.5, 0.6), mesh(s, -0.9, -0.9, 0.9, 0.9, 3);
            s.DepthRange(0, 0.4), tint(s, 6), s.Translatef(0, 0, -5), patch(s, -0.4, 0, 0.3);
            s.DepthRange(0.7, 1), tint(s, 0), s.Translatef(0, 0, 8), patch(s, 0.4, 0, 0.3);
          }),
      row("matrices.depth_range_reversed", "2.11.1", "The depth range may run backwards.",
          [](Script& s) {
            s.Enable(GL_DEPTH_TEST), s.DepthRange(1, 0), mesh(s, -0.9, -0.9, 0.9, 0.9, 3);
            s.Translatef(0, 0, -3), tint(s, 6), patch(s, -0.4, 0, 0.3);
            s.Translatef(0, 0, 6), tint(s, 0), patch(s, 0.4, 0, 0.3);
          }),
      row("matrices.depth_range_clamped", "2.11.1", "Both ends of the depth range are clamped to [0, 1].",
          [](Script& s) {
            s.DepthRange(-3, 7), s.GetFloatv(GL_DEPTH_RANGE, V{0, 1}), s.DepthRange(0.25, 0.75);
            s.GetFloatv(GL_DEPTH_RANGE, V{0.25, 0.75});
          }),
      row("matrices.at_the_vertex", "2.11", "A change of the matrix does not move what is drawn already.",
          [](Script& s) {
            arrow(s), s.LoadIdentity(), s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Viewport(0, 0, 1, 1);
          }),
  };
}

} // namespace softgl::suite
