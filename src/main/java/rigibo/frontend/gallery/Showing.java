package rigibo.frontend.gallery;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.scene.Bench;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Scene;

/** A running exhibit and its pool. */
final class Showing implements Bench {

    private final Exhibit exhibit;
    private final Pool pool;

    Showing(Exhibit exhibit) {
        this.exhibit = exhibit;
        pool = exhibit.open();
    }

    Exhibit exhibit() {
        return exhibit;
    }

    @Override
    public Pool pool() {
        return pool;
    }

    void step() {
        exhibit.beforeStep(pool);
        pool.step(Scene.STEP);
    }

    /** Bodies that touch nothing are drawn as outlines, sleeping ones dimmed. */
    static Canvas.Mood mood(RigidBody body) {
        if (!body.isEnabled() || body.isSensor()) {
            return Canvas.Mood.GHOST;
        }
        boolean isAsleep = body.type() == BodyType.DYNAMIC && !body.isAwake();
        return isAsleep ? Canvas.Mood.ASLEEP : Canvas.Mood.PLAIN;
    }
}
