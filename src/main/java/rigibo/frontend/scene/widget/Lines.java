package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;

import java.util.ArrayList;
import java.util.List;

/** Breaks texts into lines of a width. */
public final class Lines {

    private static final String MORE = "…";
    private static final String APART = "   ";

    private Lines() {}

    /**
     * A text broken between words; a word wider than a line, such as a path, is broken inside.
     *
     * @param size of the text, px
     * @param width of a line, px
     */
    public static List<String> of(
            Canvas canvas, String text, double size, Canvas.Font font, double width) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String word : text.split(" ")) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (canvas.textWidth(longer, size, font) > width && !line.isEmpty()) {
                lines.add(line);
                longer = word;
            }
            while (canvas.textWidth(longer, size, font) > width && longer.length() > 1) {
                int fitting = fitting(canvas, longer, size, font, width);
                lines.add(longer.substring(0, fitting));
                longer = longer.substring(fitting);
            }
            line = longer;
        }
        lines.add(line);
        return lines;
    }

    /**
     * Breaks a text between groups of words that stand three spaces apart, such as a key and its
     * action.
     *
     * @param size of the text, px
     * @param width of a line, px
     */
    public static List<String> ofGroups(Canvas canvas, String text, double size, double width) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String group : text.split(APART)) {
            String longer = line.isEmpty() ? group : line + APART + group;
            if (canvas.textWidth(longer, size, Canvas.Font.WORDS) > width && !line.isEmpty()) {
                lines.add(line);
                longer = group;
            }
            line = longer;
        }
        lines.add(line);
        return lines;
    }

    /** How many letters of a word fit, at least one. */
    private static int fitting(
            Canvas canvas, String word, double size, Canvas.Font font, double width) {
        int letters = 1;
        while (letters < word.length()
                && canvas.textWidth(word.substring(0, letters + 1), size, font) <= width) {
            letters++;
        }
        return letters;
    }

    /**
     * As much of a text as there is room for.
     *
     * @param size of the text, px
     * @param width of the room, px
     */
    public static String shortened(
            Canvas canvas, String text, double size, Canvas.Font font, double width) {
        if (canvas.textWidth(text, size, font) <= width) {
            return text;
        }
        int end = text.length();
        while (end > 0 && canvas.textWidth(text.substring(0, end) + MORE, size, font) > width) {
            end--;
        }
        return text.substring(0, end).stripTrailing() + MORE;
    }
}
