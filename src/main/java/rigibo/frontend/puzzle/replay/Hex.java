package rigibo.frontend.puzzle.replay;

import java.util.HexFormat;
import java.util.OptionalLong;
import java.util.regex.Pattern;

/**
 * Writes and reads hashes as hexadecimal text, since other programs would lose bits of JSON
 * numbers.
 */
final class Hex {

    private static final Pattern HASH = Pattern.compile("[0-9a-f]{16}");

    private Hex() {}

    static String of(long hash) {
        return HexFormat.of().toHexDigits(hash);
    }

    /** The hash of 16 hexadecimal digits; empty if they are not. */
    static OptionalLong read(String digits) {
        return HASH.matcher(digits).matches()
                ? OptionalLong.of(HexFormat.fromHexDigitsToLong(digits))
                : OptionalLong.empty();
    }
}
