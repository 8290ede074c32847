package rigibo.lab.plot;

import java.util.List;
import java.util.stream.IntStream;

/** The shapes of marks, which differ even without their colour. */
public enum Mark {
    DISC(24, 0),
    SQUARE(4, 45),
    DIAMOND(4, 90),
    UP(3, 90),
    DOWN(3, -90),
    PENTAGON(5, 90),
    HEXAGON(6, 0);

    private static final double RIM = 1;
    private static final double HOLLOW_RIM = 2.2;

    private final int corners;
    private final double firstDegrees;

    Mark(int corners, double firstDegrees) {
        this.corners = corners;
        this.firstDegrees = firstDegrees;
    }

    /** Draws a filled mark with a white rim that separates it from what is below. */
    public void solid(Picture picture, Spot at, double radius, String color) {
        picture.polygon(outline(at, radius), color, RIM, Palette.PAPER);
    }

    /** Draws a hollow mark, white inside. */
    public void hollow(Picture picture, Spot at, double radius, String color) {
        picture.polygon(outline(at, radius), Palette.PAPER, HOLLOW_RIM, color);
    }

    /** Draws a cross, which marks a missing value. */
    public static void cross(Picture picture, Spot at, double radius, String color) {
        double x = at.x();
        double y = at.y();
        picture.line(x - radius, y - radius, x + radius, y + radius, HOLLOW_RIM, color);
        picture.line(x - radius, y + radius, x + radius, y - radius, HOLLOW_RIM, color);
    }

    /** The corners, on a circle chosen so that all marks of a radius have the same area. */
    private List<Spot> outline(Spot at, double radius) {
        double step = 2 * Math.PI / corners;
        double reach = radius * Math.sqrt(step / Math.sin(step));
        return IntStream.range(0, corners)
                .mapToDouble(i -> Math.toRadians(firstDegrees) + i * step)
                .mapToObj(
                        angle ->
                                new Spot(
                                        at.x() + reach * Math.cos(angle),
                                        at.y() - reach * Math.sin(angle)))
                .toList();
    }
}
