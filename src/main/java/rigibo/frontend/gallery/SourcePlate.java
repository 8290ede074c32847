package rigibo.frontend.gallery;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Plate;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The source of an exhibit, from its first comment on, page by page. */
final class SourcePlate {

    private static final double SIZE = 16;

    /** From line to line, px. */
    private static final double PITCH = 20;

    private static final double PADDING = 12;

    /** With fewer letters in a line, lines are indented by half as much as they were written. */
    private static final int NARROW = 80;

    private final List<String> written;
    private final Words words;
    private int page;
    private int pages = 1;

    SourcePlate(Found found, Words words) {
        this.words = words;
        written = read(Path.of(System.getProperty("rigibo.home", "")).resolve(found.source()));
    }

    /** The source below the imports; empty if the game came without sources. */
    private static List<String> read(Path file) {
        if (!Files.exists(file)) {
            return List.of();
        }
        try {
            return Files.readAllLines(file).stream()
                    .dropWhile(line -> line.isBlank() || line.matches("(package|import) .*"))
                    .toList();
        } catch (IOException broken) {
            throw new UncheckedIOException("cannot read " + file, broken);
        }
    }

    /** Whether the game came with it. */
    boolean isThere() {
        return !written.isEmpty();
    }

    /** Moves on by a number of pages; the first follows the last. */
    void turn(int on) {
        page = Math.floorMod(page + on, pages);
    }

    /** Draws the present page at a place, px. */
    void draw(Canvas canvas, Plate at) {
        double pitch = PITCH * canvas.layout().textSize(SIZE) / SIZE;
        int rows = Math.max(1, (int) ((at.height() - 2 * PADDING) / pitch) - 1);
        List<String> lines = lines(canvas, at.width() - 2 * PADDING);
        pages = Math.max(1, (lines.size() + rows - 1) / rows);
        page = Math.min(page, pages - 1);
        canvas.panel(at.x(), at.y(), at.width(), at.height(), 12, Color.PANEL);
        double middle = at.y() + PADDING + pitch / 2;
        int end = Math.min(lines.size(), (page + 1) * rows);
        for (String line : lines.subList(page * rows, end)) {
            text(canvas, line, at.x() + PADDING, middle, Canvas.Align.LEFT, Color.TEXT);
            middle += pitch;
        }
        String number = words.of("gallery.page", page + 1, pages);
        double foot = at.bottom() - PADDING - pitch / 2;
        text(canvas, number, at.right() - PADDING, foot, Canvas.Align.RIGHT, Color.BRASS);
    }

    private static void text(
            Canvas canvas, String line, double x, double y, Canvas.Align align, Color color) {
        if (!line.isBlank()) {
            canvas.text(line, x, y, SIZE, Canvas.Font.NUMBERS, align, color);
        }
    }

    /** The lines as wide as there is room; all letters of the font are as wide as each other. */
    private List<String> lines(Canvas canvas, double width) {
        double ten = canvas.textWidth("mmmmmmmmmm", SIZE, Canvas.Font.NUMBERS);
        int letters = Math.max(20, (int) (10 * width / ten));
        List<String> lines = new ArrayList<>();
        for (String line : written) {
            String begin = line.stripLeading();
            int indent = line.length() - begin.length();
            add(lines, " ".repeat(letters < NARROW ? indent / 2 : indent), begin, letters);
        }
        return lines;
    }

    /** Adds a line, broken between words where it is too long; what follows is indented by more. */
    private static void add(List<String> lines, String indent, String words, int letters) {
        String rest = indent + words;
        while (rest.length() > letters) {
            int gap = rest.lastIndexOf(' ', letters);
            int end = gap > indent.length() + 2 ? gap : letters;
            lines.add(rest.substring(0, end));
            rest = indent + "  " + rest.substring(end).stripLeading();
        }
        lines.add(rest);
    }
}
