/**
 * A scene beside its copy at another accuracy: the distance between two pools that started equal,
 * when they became unrelated and whether that was chaos, and a {@link
 * rigibo.frontend.scene.ghost.Ghost}, which is drawn over a scene as an outline.
 */
package rigibo.frontend.scene.ghost;
