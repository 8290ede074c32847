/**
 * The same scene at another accuracy: how far two pools that began alike have come apart, when they
 * became different worlds and whether that was chaos, and a {@link
 * rigibo.frontend.scene.ghost.Ghost} that goes along with a scene as an outline.
 */
package rigibo.frontend.scene.ghost;
