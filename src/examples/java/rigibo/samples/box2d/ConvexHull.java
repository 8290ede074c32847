package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** The rubber band round points that wander. */
public final class ConvexHull implements Exhibit {
    private double phase;

    @Override
    public void build(Pool pool) {}

    @Override
    public void beforeStep(Pool pool) {
        phase += 0.01;
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        double[] xy = new double[40];
        for (int i = 0; i < 20; i++) {
            xy[2 * i] = 3 * Angle.sin(1.7 * i + phase * (1 + i % 3));
            xy[2 * i + 1] = 3 * Angle.sin(2.9 * i + phase * (1 + i % 4));
            sketch.point(xy[2 * i], xy[2 * i + 1], Sketch.Tone.PLAIN);
        }
        Polygon hull = Polygon.hull(xy);
        sketch.shape(hull, Placement.at(hull.centroidX(), hull.centroidY()));
        sketch.count(String.valueOf(hull.corners()));
    }

    @Override
    public View view() {
        return new View(0, 0, 10);
    }
}
