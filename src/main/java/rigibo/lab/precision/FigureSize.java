package rigibo.lab.precision;

/**
 * The sizes of a figure, px. A wide figure that is shrunk to a phone cannot be read, so there is a
 * narrow one as well.
 *
 * @param width of the figure
 * @param left width at the left of the plot
 * @param right width from the plot's right end to the edge
 * @param height of the plot
 * @param words size of the letters
 * @param reach largest distance of a label from its line
 */
record FigureSize(double width, double left, double right, double height, int words, double reach) {

    static final FigureSize WIDE = new FigureSize(900, 70, 24, 470, 14, 110);
    static final FigureSize NARROW = new FigureSize(400, 66, 20, 360, 13, 40);

    double plotRight() {
        return width - right;
    }
}
