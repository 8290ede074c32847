package rigibo.frontend.scene.widget;

/**
 * Places side by side and one row below the other, logical px.
 *
 * @param first the place in the upper left corner
 * @param columns how many there are side by side
 * @param gapX between two side by side
 * @param gapY between two rows
 */
public record Grid(Plate first, int columns, double gapX, double gapY) {

    /** Places side by side that fill a row, with equal gaps. */
    public static Grid of(Plate row, int columns, double gap) {
        double width = (row.width() - (columns - 1) * gap) / columns;
        return new Grid(new Plate(row.x(), row.y(), width, row.height()), columns, gap, gap);
    }

    /** One of the places, from 0. */
    public Plate place(int number) {
        return new Plate(
                first.x() + number % columns * (first.width() + gapX),
                first.y() + number / columns * (first.height() + gapY),
                first.width(),
                first.height());
    }

    /** Height of a number of places, px. */
    public double height(int places) {
        int rows = (places + columns - 1) / columns;
        return rows * (first.height() + gapY) - gapY;
    }
}
