package rigibo.frontend.draw;

import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Whether a font is as it was made. What draws text follows the offsets in its tables without
 * looking where they lead: with half of a font, or one with a few bytes changed, the process ends.
 */
final class FontFile {

    /**
     * What all 32-bit words of a font add up to (OpenType specification 1.9, "Calculating
     * Checksums": its head table holds the number that makes up the difference).
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
