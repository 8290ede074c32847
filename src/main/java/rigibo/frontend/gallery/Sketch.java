package rigibo.frontend.gallery;

import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;

/** The means by which an exhibit draws over its bodies. World coordinates in m, y up. */
public interface Sketch {

    /** The meaning of a line or a point. */
    enum Tone {
        PLAIN,
        GOOD,
        BAD
    }

    /** A straight line. */
    void line(double x1, double y1, double x2, double y2, Tone tone);

    /** A point of the same size on the screen at every scale. */
    void point(double x, double y, Tone tone);

    /** A shape as a transparent outline. */
    void shape(Shape shape, Placement at);

    /** The one number that the scene is about, shown beside its title. */
    void count(String figure);
}
