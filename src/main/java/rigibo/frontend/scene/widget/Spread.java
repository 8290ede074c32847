package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;

import java.util.List;

/** Shares a width among words side by side. */
public final class Spread {

    private Spread() {}

    /**
     * Right ends of places for words, px from the left. Each place is as wide as its word in
     * letters of the given size, px, plus an equal share of the remaining width.
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

    /**
     * Right ends of places for words, none narrower than a least width, px. What short words get in
     * addition is taken from the others.
     */
    public static double[] ends(
            Canvas canvas, List<String> words, double size, double width, double least) {
        double[] needed = new double[words.size()];
        for (int i = 0; i < needed.length; i++) {
            needed[i] = canvas.textWidth(words.get(i), size, Canvas.Font.WORDS);
        }
        boolean[] isShort = new boolean[needed.length];
        double room = room(needed, isShort, width, least);
        for (int turn = 0; turn < needed.length; turn++) {
            for (int i = 0; i < needed.length; i++) {
                isShort[i] |= needed[i] + room < least;
            }
            room = room(needed, isShort, width, least);
        }
        double[] ends = new double[needed.length];
        double end = 0;
        for (int i = 0; i < ends.length; i++) {
            end += isShort[i] ? least : needed[i] + room;
            ends[i] = end;
        }
        return ends;
    }

    /** Additional width of each place if the places of short words have the least width. */
    private static double room(double[] needed, boolean[] isShort, double width, double least) {
        double left = width;
        int others = 0;
        for (int i = 0; i < needed.length; i++) {
            left -= isShort[i] ? least : needed[i];
            others += isShort[i] ? 0 : 1;
        }
        return others == 0 ? 0 : left / others;
    }
}
