package rigibo.lab.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Finds room for labels, one after the other. A label never covers another label or a mark, crosses
 * as few lines as possible, and is near its spot. The placer tries positions on rings around the
 * spot and takes the best. If there is no room, the caller has to show the words elsewhere.
 */
public final class LabelPlacer {

    private static final int DIRECTIONS = 16;
    private static final double RING = 7;

    /** The cost of crossing a line, in px of distance. */
    private static final double LINE_COST = 30;

    /** The distance in px beyond which a thin line leads from the label to its spot. */
    private static final double NEAR = 16;

    /** The spacing of the points at which lines are tested, px. */
    private static final double STRIDE = 4;

    private final Box bounds;
    private final List<Box> taken = new ArrayList<>();
    private final List<Spot> lines = new ArrayList<>();

    private record Candidate(Box box, double cost) {}

    /** A placer within bounds. */
    public LabelPlacer(Box bounds) {
        this.bounds = bounds;
    }

    /** Keeps labels out of a box. */
    public void keepFree(Box box) {
        taken.add(box);
    }

    /** Discourages labels from crossing a line. */
    public void avoid(Spot from, Spot to) {
        double length = Math.hypot(to.x() - from.x(), to.y() - from.y());
        int pieces = (int) Math.ceil(length / STRIDE);
        for (int i = 0; i <= pieces; i++) {
            double share = pieces == 0 ? 0 : (double) i / pieces;
            lines.add(
                    new Spot(
                            from.x() + share * (to.x() - from.x()),
                            from.y() + share * (to.y() - from.y())));
        }
    }

    /** Draws a label where there is room; returns false if there is none. */
    public boolean place(Picture picture, Label label) {
        Optional<Box> room = room(label);
        room.ifPresent(box -> draw(picture, label, box));
        return room.isPresent();
    }

    private Optional<Box> room(Label label) {
        Candidate best = null;
        for (double ring = label.gap(); ring <= label.reach(); ring += RING) {
            for (int i = 0; i < DIRECTIONS; i++) {
                Candidate next = candidate(label, ring, 2 * Math.PI * i / DIRECTIONS);
                if ((best == null || next.cost() < best.cost()) && isFree(next.box())) {
                    best = next;
                }
            }
        }
        return Optional.ofNullable(best).map(Candidate::box);
    }

    private boolean isFree(Box box) {
        return bounds.holds(box) && taken.stream().noneMatch(box::overlaps);
    }

    /** Places the text's box so that it touches a circle around the spot from outside. */
    private Candidate candidate(Label label, double distance, double angle) {
        Box size = Box.of(0, 0, Anchor.START, label.size(), label.words());
        double halfWidth = (size.right() - size.left()) / 2;
        double halfHeight = (size.bottom() - size.top()) / 2;
        double x = label.of().x() + Math.cos(angle) * distance + halfWidth * side(Math.cos(angle));
        double y = label.of().y() - Math.sin(angle) * distance - halfHeight * side(Math.sin(angle));
        Box box = new Box(x - halfWidth, y - halfHeight, x + halfWidth, y + halfHeight);
        long crossed = lines.stream().filter(box::holds).count();
        return new Candidate(box, distance + (crossed > 0 ? LINE_COST : 0) + crossed);
    }

    /** The horizontal shift: fully to one side, but centred in nearly vertical directions. */
    private static double side(double share) {
        return Math.max(-1, Math.min(1, share * 1.5));
    }

    private void draw(Picture picture, Label label, Box box) {
        taken.add(box);
        Spot of = label.of();
        double nearX = Math.max(box.left(), Math.min(box.right(), of.x()));
        double nearY = Math.max(box.top(), Math.min(box.bottom(), of.y()));
        double away = Math.hypot(nearX - of.x(), nearY - of.y());
        if (away > label.gap() + NEAR) {
            picture.line(of.x(), of.y(), nearX, nearY, 1, Palette.DIM);
        }
        Box atOrigin = Box.of(0, 0, Anchor.START, label.size(), label.words());
        picture.textOver(
                box.left(),
                box.top() - atOrigin.top(),
                Anchor.START,
                label.size(),
                label.color(),
                label.words());
    }
}
