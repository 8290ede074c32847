/**
 * A scene and its copy at another accuracy: the distance between two pools that started equal, when
 * they became unrelated, and whether chaos was the cause. A {@link
 * rigibo.frontend.scene.ghost.Ghost} draws the copy over the scene, as outlines.
 */
package rigibo.frontend.scene.ghost;
