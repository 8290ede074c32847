package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;

import java.util.List;

/** Shares a width among words side by side. */
public final class Spread {

    private Spread() {}

    /**
     * Where the place of each word ends, px from the left: each is as wide as its word in letters
     * of a size, px, and has the same share of what is left of the width.
     */
    public static double[] ends(Canvas canvas, List<String> words, double size, double width) {
        double[] ends = new double[words.size()];
        double end = 0;
        for (int i = 0; i < ends.length; i++) {
            end += canvas.textWidth(words.get(i), size, Canvas.Font.WORDS);
            ends[i] = end;
        }
        double room = (width - end) / ends.length;
        for (int i = 0; i < ends.length; i++) {
            ends[i] += (i + 1) * room;
        }
        return ends;
    }
}
