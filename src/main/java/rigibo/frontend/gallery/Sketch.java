package rigibo.frontend.gallery;

import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;

/** The means by which an exhibit draws over its bodies. World coordinates in m, y up. */
public interface Sketch {

    /** What a line or a point tells. */
    enum Tone {
        PLAIN,
        GOOD,
        BAD
    }

    /** A straight line. */
    void line(double x1, double y1, double x2, double y2, Tone tone);

    /** A point, as large on the screen at every scale. */
    void point(double x, double y, Tone tone);

    /** A shape as an outline that one sees through. */
    void shape(Shape shape, Placement at);

    /** Numbers and signs, no words: the gallery speaks several languages. Centred at a point. */
    void number(double x, double y, String figure);

    /** The one number that the scene is about, shown beside its title. */
    void count(String figure);
}
