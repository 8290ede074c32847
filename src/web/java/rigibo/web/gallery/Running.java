package rigibo.web.gallery;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.gallery.Exhibit;

/** An exhibit and its pool. */
final class Running {

    private static final double STEP = 1.0 / 60;

    final Exhibit exhibit;
    final Pool pool;

    Running(Exhibit exhibit, Accuracy accuracy) {
        this.exhibit = exhibit;
        pool = exhibit.open();
        pool.accuracy(accuracy);
    }

    void advance(int steps) {
        for (int i = 0; i < steps; i++) {
            exhibit.beforeStep(pool);
            pool.step(STEP);
        }
    }
}
