package rigibo.backend.geometry;

import java.util.ArrayList;
import java.util.List;

/** Shapes in one piece, put together of many that have the same outline. */
public final class Pieces {

    private Pieces() {}

    /** A polygon as wedges from its centre, a disc as one with smaller discs in it. */
    public static Compound of(Shape shape) {
        return shape instanceof Polygon polygon ? wedges(polygon) : discs((Circle) shape);
    }

    /** A wedge from the centre for each edge. */
    public static Compound wedges(Polygon polygon) {
        List<Part> parts = new ArrayList<>();
        int count = polygon.corners();
        for (int i = 0; i < count; i++) {
            int next = (i + 1) % count;
            Polygon wedge =
                    Polygon.of(
                            0,
                            0,
                            polygon.cornerX(i),
                            polygon.cornerY(i),
                            polygon.cornerX(next),
                            polygon.cornerY(next));
            parts.add(Part.of(wedge).at(wedge.centroidX(), wedge.centroidY()));
        }
        return Compound.of(parts);
    }

    /** The disc, and two that weigh nothing inside it. */
    public static Compound discs(Circle disc) {
        double half = disc.radius() / 2;
        Part inside = Part.of(new Circle(0.4 * disc.radius())).relativeDensity(0);
        return Compound.of(Part.of(disc), inside.at(half, 0), inside.at(-half, 0));
    }

    /** A bottom and two walls that reach as far as told from the centre of mass, or less, m. */
    public static Compound cup(double reach) {
        double side = 1.2 * reach;
        double thick = 0.2 * side;
        Polygon wall = Polygon.box(thick, 0.8 * side);
        double aside = (side - thick) / 2;
        return Compound.of(
                Part.of(Polygon.box(side, thick)),
                Part.of(wall).at(-aside, side / 2),
                Part.of(wall).at(aside, side / 2));
    }
}
