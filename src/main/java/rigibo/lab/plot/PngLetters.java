package rigibo.lab.plot;

import java.awt.Font;
import java.awt.FontFormatException;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.font.GlyphVector;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The letters of raster pictures. They are the game's own, so that pictures do not depend on
 * installed fonts. The game's font lacks some superscript digits, which are drawn as smaller
 * digits.
 */
public final class PngLetters {

    private static final String RAISED = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹";
    private static final String PLAIN = "−0123456789";
    private static final double RAISED_SIZE = 0.62;
    private static final double RAISED_BY = 0.36;

    /** Letters are laid out without regard to pixels. */
    private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

    private final Font words;
    private final Font others;

    private PngLetters(Font words, Font others) {
        this.words = words;
        this.others = others;
    }

    /** The game's letters; empty if this Java cannot draw letters at all. */
    public static Optional<PngLetters> find() {
        System.setProperty("java.awt.headless", "true");
        try {
            PngLetters letters =
                    new PngLetters(font("Quicksand-Bold.ttf"), font("JetBrainsMono-Medium.ttf"));
            letters.width("a", 1);
            return Optional.of(letters);
        } catch (IOException | FontFormatException | RuntimeException | LinkageError none) {
            // Java without FreeType or fontconfig fails in each of these ways.
            return Optional.empty();
        }
    }

    private static Font font(String name) throws IOException, FontFormatException {
        Path home = Path.of(System.getProperty("rigibo.home", "."), "assets", "fonts", name);
        return Font.createFont(Font.TRUETYPE_FONT, home.toFile());
    }

    /** px. */
    double width(String text, int size) {
        return text.codePoints().mapToDouble(letter -> glyph(letter, size).width).sum();
    }

    /** From the origin to the right. */
    Shape outline(String text, int size) {
        Path2D outline = new Path2D.Double();
        double x = 0;
        for (int letter : text.codePoints().toArray()) {
            Glyph glyph = glyph(letter, size);
            outline.append(
                    AffineTransform.getTranslateInstance(x, -glyph.rise)
                            .createTransformedShape(glyph.shape),
                    false);
            x += glyph.width;
        }
        return outline;
    }

    private record Glyph(Shape shape, double width, double rise) {}

    private Glyph glyph(int letter, int size) {
        int raised = RAISED.indexOf(letter);
        return raised < 0
                ? glyph(letter, size, 0)
                : glyph(PLAIN.codePointAt(raised), RAISED_SIZE * size, RAISED_BY * size);
    }

    private Glyph glyph(int letter, double size, double rise) {
        Font font = (words.canDisplay(letter) ? words : others).deriveFont((float) size);
        GlyphVector glyphs = font.createGlyphVector(CONTEXT, Character.toString(letter));
        return new Glyph(glyphs.getOutline(), glyphs.getGlyphPosition(1).getX(), rise);
    }
}
