package rigibo.frontend.editor.draft;

/** Snaps points to the grid. */
public enum Grid {
    OFF(1e-3),
    ON(0.05);

    private final double pitch;

    Grid(double pitch) {
        this.pitch = pitch;
    }

    /** The other state of the grid. */
    public Grid switched() {
        return this == ON ? OFF : ON;
    }

    /** Distance between two lines, m. */
    public double pitch() {
        return pitch;
    }

    /** The nearest line, m. */
    public double snap(double metres) {
        return Decimal.rounded(Math.round(metres / pitch) * pitch);
    }

    /** The nearest crossing of lines. */
    public Point snap(Point point) {
        return new Point(snap(point.x()), snap(point.y()));
    }

    /**
     * Returns the item with its left and lower edges on grid lines, so that items of any size stand
     * flush; an oblique item is placed on them by its position.
     */
    public Item snap(Item item) {
        if (Math.IEEEremainder(item.degrees(), 90) != 0) {
            return item.at(snap(item.place()));
        }
        Point lowest = lowest(item);
        return item.at(item.place().plus(snap(lowest).minus(lowest)));
    }

    private static Point lowest(Item item) {
        if (item.form() instanceof Disc disc) {
            return item.place().minus(new Point(disc.radius(), disc.radius()));
        }
        return new Point(
                item.corners().stream().mapToDouble(Point::x).min().orElse(item.place().x()),
                item.corners().stream().mapToDouble(Point::y).min().orElse(item.place().y()));
    }
}
