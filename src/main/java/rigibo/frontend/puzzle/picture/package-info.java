/**
 * How things of a level look, whether they move or not: skins, the goal and its flag, joints, the
 * signs of verbs, and pictures of whole levels. Lengths in m of the world, or px where a name says
 * so. Knows what a level states; no rules and no game.
 */
package rigibo.frontend.puzzle.picture;
