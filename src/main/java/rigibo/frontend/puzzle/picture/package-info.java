/**
 * The look of a level's parts, moving or not: skins, the goal and its flag, joints, the signs of
 * verbs, and pictures of whole levels. Lengths in m of the world, or px where a name says so. Knows
 * the definitions of a level; no rules and no game.
 */
package rigibo.frontend.puzzle.picture;
