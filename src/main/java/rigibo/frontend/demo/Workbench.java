package rigibo.frontend.demo;

import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.scene.Bench;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Grip;
import rigibo.frontend.scene.Impacts;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.Sounds;
import rigibo.frontend.scene.ghost.Ghost;
import rigibo.frontend.scene.joint.JointPicture;

import java.util.IdentityHashMap;
import java.util.Map;
import java.util.function.Consumer;

/** A pool on the screen: bodies with skins, a camera, and a hand that drags and throws. */
final class Workbench implements Bench {

    private final Pool pool;
    private final Camera camera;
    private final Map<RigidBody, Skin> skins = new IdentityHashMap<>();
    private final Impacts impacts = new Impacts();
    private final Grip grip = new Grip();

    /**
     * A copy of the scene at another accuracy, or null; and the scene's accuracy when it was made.
     */
    private Ghost ghost;

    private Accuracy hauntedAt;

    Workbench(Effects effects, Camera camera) {
        this.camera = camera;
        pool = new Pool(effects, Accuracy.GAME);
        pool.clock(System::nanoTime);
    }

    @Override
    public Pool pool() {
        return pool;
    }

    Camera camera() {
        return camera;
    }

    /** Ends the threads that share steps, if there are any. */
    void close() {
        pool.close();
    }

    RigidBody add(BodyDefinition definition, Skin skin) {
        RigidBody body = pool.add(definition);
        skins.put(body, skin);
        if (ghost != null) {
            ghost.added(body, definition);
        }
        return body;
    }

    /** Acts on a body, and on its ghost if there is one. */
    @Override
    public void act(RigidBody body, Consumer<RigidBody> verb) {
        verb.accept(body);
        if (ghost != null) {
            ghost.act(body, verb);
        }
    }

    /** Acts on a joint, and on its ghost if there is one. */
    @Override
    public void act(Joint joint, Consumer<Joint> verb) {
        verb.accept(joint);
        if (ghost != null) {
            ghost.act(joint, verb);
        }
    }

    @Override
    public Joint join(JointDefinition definition) {
        Joint joint = pool.join(definition);
        if (ghost != null) {
            ghost.joined(joint, definition);
        }
        return joint;
    }

    @Override
    public void part(Joint joint) {
        pool.remove(joint);
        if (ghost != null) {
            ghost.parted(joint);
        }
    }

    void remove(RigidBody body) {
        skins.remove(body);
        pool.remove(body);
        if (ghost != null) {
            ghost.removed(body);
        }
    }

    /** Removes bodies that fell below a height, m. */
    void removeBelow(double y) {
        for (RigidBody body : pool.bodies().toArray(new RigidBody[0])) {
            if (body.y() < y) {
                remove(body);
            }
        }
    }

    /** Takes hold of the dynamic body under a point, world m, if there is one. */
    void grab(double x, double y) {
        grip.grab(this, x, y);
    }

    void letGo() {
        grip.letGo();
    }

    /** Whether the hand holds something. */
    boolean isHeld() {
        return grip.held().isPresent();
    }

    /** Sets the position of the pointer in the world, m. */
    void point(double x, double y) {
        grip.point(x, y);
    }

    double pointerX() {
        return grip.pointerX();
    }

    double pointerY() {
        return grip.pointerY();
    }

    /** Pulls the held body towards the pointer; once released, it keeps its speed. */
    void pull() {
        grip.pull();
    }

    /** Advances the scene, and its ghost, by a step of {@code dt} seconds. */
    void step(double dt) {
        pool.step(dt);
        if (ghost != null) {
            ghost.step(dt);
        }
    }

    /**
     * Reports the impacts of the last step as sounds, unless the sound is off: a flood has
     * thousands of impacts.
     */
    void tell(Sounds sounds) {
        if (sounds.isHeard()) {
            impacts.tell(pool, skins::get, sounds);
        }
    }

    /**
     * Makes or removes the ghost, a copy of the scene's present state. When the scene's accuracy
     * changes, a new ghost is made.
     */
    void haunt(boolean isHaunted) {
        boolean isStale = ghost != null && !pool.accuracy().equals(hauntedAt);
        if (!isHaunted || isStale) {
            ghost = null;
        }
        if (isHaunted && ghost == null) {
            haunt(Ghost.of(pool));
        }
    }

    /** Makes a ghost of the scene's present state, at a given accuracy. */
    void haunt(Ghost certain) {
        ghost = certain;
        hauntedAt = pool.accuracy();
    }

    /** The ghost, or null if there is none. */
    Ghost ghost() {
        return ghost;
    }

    void draw(Canvas canvas) {
        canvas.camera(camera);
        canvas.gaze(pointerX(), pointerY());
        RigidBody held = grip.held().orElse(null);
        for (RigidBody body : pool.bodies()) {
            if (isInView(canvas, camera, body)) {
                boolean isAsleep = body.type() == BodyType.DYNAMIC && !body.isAwake();
                Canvas.Mood mood =
                        body == held
                                ? Canvas.Mood.HOVERED
                                : isAsleep ? Canvas.Mood.ASLEEP : Canvas.Mood.PLAIN;
                canvas.body(body.shape(), body.x(), body.y(), body.angle(), skins.get(body), mood);
            }
        }
        JointPicture.draw(canvas, camera, pool.joints());
        if (ghost != null) {
            ghost.draw(canvas);
        }
    }

    /** Whether any of a body may be in the window. */
    static boolean isInView(Canvas canvas, Camera camera, RigidBody body) {
        double radius = body.shape().boundingRadius() * camera.scale();
        return canvas.layout().shows(camera.screenX(body.x()), camera.screenY(body.y()), radius);
    }

    /** Draws what the pool holds and the bodies do not show, after a step of some seconds. */
    void drawDebug(Canvas canvas, double step) {
        pool.draw(new DebugPen(canvas, camera, step), DebugPen.LAYERS);
    }
}
