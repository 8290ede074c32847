package rigibo.examples;

import rigibo.backend.HitEvent;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Hits: which bodies met, how fast, and when within the step. Bars flash as balls fall on them. */
public final class Chimes implements Exhibit {

    private static final double FADE = 1; // s

    /** Balls and bars from the left, and when each bar was struck last, s. */
    final List<RigidBody> balls = new ArrayList<>();

    final List<RigidBody> bars = new ArrayList<>();
    private final Map<RigidBody, Double> struck = new IdentityHashMap<>();

    /** The last hit of the last ball, m/s. */
    double speed;

    @Override
    public void build(Pool pool) {
        for (int i = 0; i < 6; i++) {
            double x = 1.3 * (i - 2.5);
            bars.add(pool.add(BodyDefinition.fixed(Polygon.box(1, 0.2)).at(x, 0.5)));
            balls.add(
                    pool.add(
                            BodyDefinition.dynamic(new Circle(0.25))
                                    .at(x, 2 + 0.7 * i)
                                    .material(new Material(500, 0.3, 0.8))));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        for (HitEvent hit : pool.hits()) {
            RigidBody bar = bars.contains(hit.a()) ? hit.a() : hit.b();
            struck.put(bar, pool.time());
            speed = hit.speed();
        }
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (RigidBody bar : bars) {
            double ago = pool.time() - struck.getOrDefault(bar, -FADE);
            double height = 0.8 * Math.max(0, 1 - ago / FADE);
            for (int i = 0; i < 3 && height > 0; i++) {
                double x = bar.x() + 0.3 * (i - 1);
                sketch.line(x, 0.3, x, 0.3 - height, Sketch.Tone.GOOD);
            }
        }
        sketch.count(String.format(Locale.ROOT, "%.2f m/s", speed));
    }

    @Override
    public View view() {
        return new View(0, 3, 9);
    }
}
