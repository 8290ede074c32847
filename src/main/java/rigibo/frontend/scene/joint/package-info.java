/**
 * Pictures of joints: ropes that sag, springs with coils, rods, brass pins, rails, toothed wheels.
 * World coordinates are m with y up; nothing here knows OpenGL.
 */
package rigibo.frontend.scene.joint;
