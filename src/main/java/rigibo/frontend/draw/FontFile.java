package rigibo.frontend.draw;

import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Checks that a font file is unaltered. The library that draws text follows offsets in the font's
 * tables without checking them: with a truncated or altered font the process crashes.
 */
final class FontFile {

    /**
     * Sum of all 32-bit words of an unaltered font (OpenType specification 1.9, "Calculating
     * Checksums": the head table holds the number that makes up the difference).
     */
    private static final int SUM = 0xB1B0AFBA;

    private FontFile() {}

    static boolean isSound(byte[] font) {
        ByteBuffer words = ByteBuffer.wrap(Arrays.copyOf(font, (font.length + 3) & ~3));
        int sum = 0;
        while (words.hasRemaining()) {
            sum += words.getInt();
        }
        return sum == SUM;
    }
}
