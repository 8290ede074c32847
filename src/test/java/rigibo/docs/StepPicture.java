package rigibo.docs;

import rigibo.backend.setup.StepStage;
import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Spot;

import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The stages of a step: what comes after what, and the two ways for bodies to move. */
final class StepPicture {

    private static final double WIDTH = 720; // px
    private static final double BOX_WIDTH = 240; // px
    private static final double BOX_HEIGHT = 52; // px
    private static final double GAP = 26; // px
    private static final double MIDDLE = WIDTH / 2; // px
    private static final double SIDE = 170; // px, from the middle to the boxes beside each other

    /** The data of a stage, written under its name. */
    private static final Map<StepStage, String> WORK =
            Map.of(
                    StepStage.ACCEPT, "what you added and removed",
                    StepStage.EFFECTS, "accelerations",
                    StepStage.BROADPHASE, "pairs that may touch",
                    StepStage.CLASSIFY, "contact points; flight or pile?",
                    StepStage.FLIGHT, "exact paths, impacts in time order",
                    StepStage.CONTACT, "islands, in substeps",
                    StepStage.REST, "sleep",
                    StepStage.REPORT, "events and counts for you");

    private final Drawing drawing = new Drawing(WIDTH);
    private double y = GAP;

    private StepPicture() {}

    static String svg() {
        StepPicture picture = new StepPicture();
        picture.draw();
        return picture.drawing.svg();
    }

    private void draw() {
        for (StepStage stage : StepStage.values()) {
            boolean isBeside = stage == StepStage.FLIGHT || stage == StepStage.CONTACT;
            double x = isBeside ? MIDDLE + (stage == StepStage.FLIGHT ? -SIDE : SIDE) : MIDDLE;
            box(stage, x);
            if (stage == StepStage.FLIGHT) {
                continue; // The piles stand beside it.
            }
            if (stage == StepStage.CLASSIFY) {
                arrow(MIDDLE, -SIDE);
                arrow(MIDDLE, SIDE);
            } else if (stage == StepStage.CONTACT) {
                join();
            } else if (stage != StepStage.REPORT) {
                arrow(MIDDLE, 0);
            }
            y += BOX_HEIGHT + GAP;
        }
        drawing.endAt(y);
    }

    private void box(StepStage stage, double x) {
        boolean isMotion = stage == StepStage.FLIGHT || stage == StepStage.CONTACT;
        List<Spot> corners =
                List.of(
                        new Spot(x - BOX_WIDTH / 2, y),
                        new Spot(x + BOX_WIDTH / 2, y),
                        new Spot(x + BOX_WIDTH / 2, y + BOX_HEIGHT),
                        new Spot(x - BOX_WIDTH / 2, y + BOX_HEIGHT));
        drawing.polygon(corners, isMotion ? Palette.BAND : Palette.PAPER, 1.5, Palette.BLUE);
        String name = stage.name().toLowerCase(Locale.ROOT);
        drawing.text(x, y + 22, Anchor.MIDDLE, 16, Palette.INK, name);
        drawing.text(x, y + 41, Anchor.MIDDLE, 13, Palette.DIM, WORK.get(stage));
    }

    /** From the foot of the box above to the next row. */
    private void arrow(double x, double aside) {
        tipped(x + aside / 2, y + BOX_HEIGHT, x + aside, y + BOX_HEIGHT + GAP);
    }

    /** Both ways lead on to the same stage; a flyer that lands changes from one to the other. */
    private void join() {
        double foot = y + BOX_HEIGHT;
        tipped(MIDDLE - SIDE, foot, MIDDLE - SIDE / 2, foot + GAP);
        tipped(MIDDLE + SIDE, foot, MIDDLE + SIDE / 2, foot + GAP);
        double from = MIDDLE - SIDE + BOX_WIDTH / 2;
        double to = MIDDLE + SIDE - BOX_WIDTH / 2;
        tipped(from, y + BOX_HEIGHT / 2, to, y + BOX_HEIGHT / 2);
        drawing.text(MIDDLE, y + BOX_HEIGHT / 2 - 8, Anchor.MIDDLE, 13, Palette.DIM, "landing");
    }

    private void tipped(double fromX, double fromY, double toX, double toY) {
        Arrow.draw(drawing, new Spot(fromX, fromY), new Spot(toX, toY), Palette.INK);
    }
}
