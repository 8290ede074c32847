/**
 * The scenes of the puzzle: a level in play, a replay, a level that is being made, pages of levels,
 * errors of files; and the entries that lead to them. A scene passes input and frames to its rooms,
 * each of which has one meaning; no room knows a scene. Lengths in m of the world, or px of the
 * logical 720 × 800 scene where a name says so. Knows no OpenGL.
 */
package rigibo.frontend.puzzle;
