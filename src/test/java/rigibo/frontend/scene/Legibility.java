package rigibo.frontend.scene;

import rigibo.frontend.scene.RecordingCanvas.Mark;

import java.util.ArrayList;
import java.util.List;

/** Finds faults in the texts of a picture. */
public final class Legibility {

    /** The smallest text that everyone can read, px of the screen. */
    private static final double SMALLEST = 16;

    /** In a handheld window, which is nearer to the eyes. */
    private static final double SMALLEST_IN_HAND = 14;

    private static final double ROUND_OFF = 1e-9;

    /** A button in a row of a panel is drawn so much within what is touched, above and below. */
    private static final double ROW_GAP = 2;

    private static final Layout SMALLEST_WINDOW = Layout.of(612, 680, 1);

    /** Phones with and without a notch, upright and lying. */
    public static final List<Layout> HANDS =
            List.of(
                    Layout.inHand(360, 640, 1, Edges.NONE),
                    Layout.inHand(390, 844, 1, new Edges(0, 47, 0, 34)),
                    Layout.inHand(640, 360, 1, Edges.NONE),
                    Layout.inHand(844, 390, 1, new Edges(47, 0, 47, 21)));

    private Legibility() {}

    /** One sentence for each fault of a scene in a handheld window. */
    public static List<String> faultsInHand(Scene scene) {
        List<String> faults = new ArrayList<>();
        for (Layout layout : hands(scene)) {
            String where = " in a hand, " + layout.width() + " by " + layout.height();
            faults(scene, layout).forEach(fault -> faults.add(fault + where));
        }
        return faults;
    }

    /** The layouts that a scene has on phones. */
    public static List<Layout> hands(Scene scene) {
        return HANDS.stream().map(hand -> scene.isSheet() ? hand.sheet() : hand).toList();
    }

    /**
     * One sentence for each plate that looks like a button, since it is lit and has words in its
     * middle, and is too small for a finger.
     */
    public static List<String> tooSmallForFingers(Scene scene, Layout layout) {
        double least = layout.touch().least() - 2 * ROW_GAP * layout.type();
        return RecordingCanvas.of(scene, layout).buttons().stream()
                .filter(button -> button.shorterSide() < least - ROUND_OFF)
                .map(button -> button + " is too small for a finger")
                .toList();
    }

    /**
     * One sentence for each text that leaves the window or its panel, meets another text, is too
     * small or has letters that its font lacks, in the usual window or in the smallest one; none
     * when all is well.
     */
    public static List<String> faults(Scene scene) {
        List<String> faults = new ArrayList<>();
        for (double share : new double[] {1.3, 1.15}) {
            faults(scene, Layout.ALONE.withText(share, scene.mostType()))
                    .forEach(fault -> faults.add(fault + " with text of " + share));
        }
        faults(scene, SMALLEST_WINDOW.withText(1.3, scene.mostType()))
                .forEach(fault -> faults.add(fault + " in a small window with large text"));
        faults(scene, SMALLEST_WINDOW).forEach(fault -> faults.add(fault + " in a small window"));
        // The usual one last: what is pressed afterwards is where it was drawn last.
        faults.addAll(faults(scene, Layout.ALONE));
        return faults;
    }

    /** Everything that cannot be read in a window of the given shape and size. */
    public static List<String> faults(Scene scene, Layout layout) {
        List<Mark> marks = RecordingCanvas.of(scene, layout).marks();
        List<String> faults = new ArrayList<>();
        for (int i = 0; i < marks.size(); i++) {
            if (marks.get(i).isText()) {
                judge(marks, i, layout, faults);
            }
        }
        return faults;
    }

    private static void judge(List<Mark> marks, int at, Layout layout, List<String> faults) {
        Mark text = marks.get(at);
        Mark window =
                new Mark(
                        "",
                        null,
                        layout.seenLeft(),
                        layout.seenTop(),
                        layout.seenRight(),
                        layout.seenBottom());
        if (!window.contains(text)) {
            faults.add(text + " leaves the window");
        }
        double smallest = layout.isInHand() ? SMALLEST_IN_HAND : SMALLEST;
        if ((text.bottom() - text.top()) * layout.ratio() < smallest - ROUND_OFF) {
            faults.add(text + " is too small");
        }
        if (!text.face().missing(text.words()).isEmpty()) {
            faults.add(text + " has no letters for " + text.face().missing(text.words()));
        }
        Mark panel = panelOf(marks, at, window);
        if (!panel.contains(text)) {
            faults.add(text + " leaves its " + panel);
        }
        for (Mark later : marks.subList(at + 1, marks.size())) {
            if (later.overlaps(text)) {
                faults.add(text + " is under " + later);
            }
        }
    }

    /** The uppermost panel that the text was drawn on, or the window. */
    private static Mark panelOf(List<Mark> marks, int text, Mark window) {
        for (int i = text - 1; i >= 0; i--) {
            Mark mark = marks.get(i);
            if (!mark.isText() && mark.containsMiddleOf(marks.get(text))) {
                return mark;
            }
        }
        return window;
    }
}
