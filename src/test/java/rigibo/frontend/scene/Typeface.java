package rigibo.frontend.scene;

import static org.lwjgl.stb.STBTruetype.stbtt_FindGlyphIndex;
import static org.lwjgl.stb.STBTruetype.stbtt_GetCodepointHMetrics;
import static org.lwjgl.stb.STBTruetype.stbtt_InitFont;
import static org.lwjgl.stb.STBTruetype.stbtt_ScaleForMappingEmToPixels;

import org.lwjgl.stb.STBTTFontinfo;
import org.lwjgl.system.MemoryUtil;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;

/** The widths of a font of the game, measured as NanoVG does, without a window. */
final class Typeface {

    static final Typeface WORDS = new Typeface("Quicksand-Bold.ttf");
    static final Typeface NUMBERS = new Typeface("JetBrainsMono-Medium.ttf");

    private final STBTTFontinfo font = STBTTFontinfo.create();

    /** The font reads from its file's bytes for as long as it is used, so they are kept. */
    private final ByteBuffer bytes;

    private final int[] advance = new int[1];
    private final int[] bearing = new int[1];

    private Typeface(String file) {
        byte[] read = read(file);
        bytes = MemoryUtil.memAlloc(read.length).put(read).flip();
        if (!stbtt_InitFont(font, bytes)) {
            throw new IllegalStateException("cannot read the font " + file);
        }
    }

    private static byte[] read(String file) {
        Path fonts = Path.of(System.getProperty("rigibo.home", ""), "assets", "fonts");
        try {
            return Files.readAllBytes(fonts.resolve(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** How wide a text is at a size in px. */
    double width(String words, double size) {
        double units =
                words.codePoints()
                        .mapToDouble(
                                point -> {
                                    stbtt_GetCodepointHMetrics(font, point, advance, bearing);
                                    return advance[0];
                                })
                        .sum();
        return units * stbtt_ScaleForMappingEmToPixels(font, (float) size);
    }

    /** The letters of a text that the font does not have, which would be drawn as empty boxes. */
    String missing(String words) {
        return words.codePoints()
                .filter(point -> stbtt_FindGlyphIndex(font, point) == 0)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                .toString();
    }
}
