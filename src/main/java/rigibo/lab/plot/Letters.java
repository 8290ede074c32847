package rigibo.lab.plot;

import java.util.ArrayList;
import java.util.List;

/**
 * An upper bound of a text's width. A browser chooses the font itself, and without installed fonts
 * none can be measured. So the wider of two fonts counts: DejaVu Sans, the widest common one, and
 * Quicksand, the font of our own pictures.
 */
public final class Letters {

    /** Widths in hundredths of the letters' size, from the space to the tilde. */
    private static final int[] WIDTHS = {
        32, 41, 46, 84, 64, 96, 78, 28, 40, 40, 50, 84, 32, 40, 32, 57, // space to /
        64, 64, 64, 64, 71, 64, 64, 64, 64, 64, 34, 34, 84, 84, 84, 54, // 0 to ?
        100, 69, 69, 70, 78, 64, 58, 78, 76, 30, 56, 66, 57, 87, 75, 79, // @ to O
        61, 79, 70, 64, 63, 74, 69, 99, 69, 62, 69, 41, 57, 41, 84, 71, // P to _
        50, 63, 64, 55, 64, 62, 42, 64, 64, 28, 28, 58, 28, 98, 64, 62, // ` to o
        64, 64, 44, 53, 41, 64, 60, 82, 60, 60, 53, 64, 34, 64, 84 // p to ~
    };

    private static final String RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹·";
    private static final int RAISED_WIDTH = 44;

    /** The width of a letter that is in neither list, that of mathematical signs. */
    private static final int OTHER_WIDTH = 84;

    private Letters() {}

    /** The width in px of a text in letters of a size. */
    public static double width(String words, int size) {
        return words.chars().map(Letters::width).sum() * size / 100.0;
    }

    /** Breaks a text into lines that are no wider than a width in px. */
    public static List<String> lines(String words, int size, double width) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String word : words.split(" ")) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (!line.isEmpty() && width(longer, size) > width) {
                lines.add(line);
                longer = word;
            }
            line = longer;
        }
        lines.add(line);
        return lines;
    }

    private static int width(int letter) {
        int index = letter - ' ';
        if (index >= 0 && index < WIDTHS.length) {
            return WIDTHS[index];
        }
        return RAISED.indexOf(letter) >= 0 ? RAISED_WIDTH : OTHER_WIDTH;
    }
}
