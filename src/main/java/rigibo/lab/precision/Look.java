package rigibo.lab.precision;

import rigibo.lab.engine.Line;
import rigibo.lab.plot.Mark;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Picture;
import rigibo.lab.plot.Spot;

/**
 * The appearance of a line or an engine, which is the same in every figure.
 *
 * @param color of its line and its marks
 * @param mark of its points
 * @param radius of its marks, px
 * @param isHollow whether they are white within
 */
record Look(String color, Mark mark, double radius, boolean isHollow) {

    private static final double SMALL = 4.5;
    private static final double LARGE = 7.5;

    /** The appearances of other engines, in their order. */
    private static final Mark[] PEERS = {Mark.UP, Mark.SQUARE, Mark.HEXAGON, Mark.DOWN};

    /** The colours of other engines and their names, so that close marks differ. */
    private static final String[] PEER_COLORS = {Palette.PURPLE, Palette.VERMILLION, Palette.DIM};

    /** The appearance of one of our lines. Lines of one colour have different marks. */
    static Look of(Line line) {
        return switch (line) {
            case PRESETS -> new Look(Palette.INK, Mark.DISC, LARGE, false);
            case PEERS -> peer(0);
            case STEP -> swept(Palette.BLUE, Mark.DISC);
            case STEP_EULER -> swept(Palette.VERMILLION, Mark.UP);
            case STEP_VERLET -> swept(Palette.GREEN, Mark.SQUARE);
            case STEP_RK4 -> swept(Palette.ORANGE, Mark.DIAMOND);
            case STEP_DISCRETE -> swept(Palette.VERMILLION, Mark.DOWN);
            case STEP_SPLIT -> swept(Palette.SKY, Mark.SQUARE);
            case SUBSTEPS -> swept(Palette.GREEN, Mark.DISC);
            case ITERATIONS -> swept(Palette.ORANGE, Mark.SQUARE);
            case TOLERANCE -> swept(Palette.SKY, Mark.DIAMOND);
            case IMPACTS_PER_PAIR -> swept(Palette.ORANGE, Mark.PENTAGON);
            case SEARCH -> choice(Palette.SKY);
            case SOLVER -> choice(Palette.BLUE);
            case CORRECTION -> choice(Palette.VERMILLION);
        };
    }

    /** The appearance of another engine, by its index. */
    static Look peer(int index) {
        return new Look(
                PEER_COLORS[index % PEER_COLORS.length],
                PEERS[index % PEERS.length],
                LARGE - 0.5,
                true);
    }

    private static Look swept(String color, Mark mark) {
        return new Look(color, mark, SMALL, false);
    }

    private static Look choice(String color) {
        return new Look(color, Mark.DISC, SMALL, true);
    }

    void draw(Picture picture, Spot at) {
        if (isHollow) {
            mark.hollow(picture, at, radius, color);
        } else {
            mark.solid(picture, at, radius, color);
        }
    }

    /** The colour of its label. */
    String wordsColor() {
        return Palette.forLetters(color);
    }
}
