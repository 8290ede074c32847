package rigibo.docs;

import rigibo.lab.plot.Picture;
import rigibo.lab.plot.Spot;

import java.util.List;

/** A straight line with a tip at its end. */
public final class Arrow {

    private static final double TIP = 8; // px
    private static final double WIDTH = 1.75; // px

    private Arrow() {}

    /** Draws one from a place to another, px. */
    public static void draw(Picture picture, Spot from, Spot to, String color) {
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        double length = Math.hypot(dx, dy);
        double tipX = TIP * dx / length;
        double tipY = TIP * dy / length;
        Spot neck = new Spot(to.x() - tipX, to.y() - tipY);
        picture.line(from.x(), from.y(), neck.x(), neck.y(), WIDTH, color);
        Spot left = new Spot(neck.x() - tipY / 2, neck.y() + tipX / 2);
        Spot right = new Spot(neck.x() + tipY / 2, neck.y() - tipX / 2);
        picture.polygon(List.of(to, left, right), color, 1, color);
    }
}
