package rigibo.frontend.document;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.document.ShareCode.Kind;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Base64;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

class ShareCodeTest {

    private static final String START = "RIGIBO-LEVEL-";
    private static final JsonNode DOCUMENT =
            JsonMapper.shared().readTree("{\"title\": \"Größe 𝄞\", \"bodies\": [1, 2.5e-3]}");

    private final Problems problems = new Problems("code");

    private static String code() {
        return ShareCode.of(Kind.LEVEL, DOCUMENT).orElseThrow();
    }

    private String problem() {
        return problems.inOrder().get(0).message();
    }

    private static String random(SplittableRandom random, int letters) {
        StringBuilder text = new StringBuilder();
        random.ints(letters, 33, 127).forEach(letter -> text.append((char) letter));
        return text.toString();
    }

    @Test
    void whatWasPackedComesOutAgain() {
        for (Kind kind : Kind.values()) {
            String code = ShareCode.of(kind, DOCUMENT).orElseThrow();
            assertThat(code).matches("RIGIBO-[A-Z]+-[A-Za-z0-9_-]+");
            ShareCode read = ShareCode.read(code, problems).orElseThrow();
            assertThat(read.kind()).isEqualTo(kind);
            assertThat(JsonMapper.shared().readTree(read.text())).isEqualTo(DOCUMENT);
        }
        assertThat(problems.hasErrors()).isFalse();
    }

    @Test
    void linesAndSpacesDoNotMatter() {
        String broken = "\n  " + code().replaceAll("(.{7})", "$1 \r\n") + "\t";
        assertThat(ShareCode.read(broken, problems)).isEqualTo(ShareCode.read(code(), problems));
        assertThat(problems.hasErrors()).isFalse();
    }

    /** A checksum of 32 bits lets one of four thousand million damaged codes pass. */
    @Test
    void everyWrongMissingOrAdditionalLetterIsFound() {
        String code = code();
        for (int i = START.length(); i < code.length(); i++) {
            char other = code.charAt(i) == 'A' ? 'B' : 'A';
            assertDamaged(code.substring(0, i) + other + code.substring(i + 1));
            assertDamaged(code.substring(0, i) + code.substring(i + 1));
            assertDamaged(code.substring(0, i));
            assertDamaged(code.substring(0, i) + other + code.substring(i));
        }
        assertDamaged(code + "AAAA");
        assertDamaged(code.substring(0, START.length() + 5) + "ß" + code.substring(30));
    }

    private static void assertDamaged(String code) {
        Problems told = new Problems("code");
        // The last letter may hold bits that no byte uses; then another one says the same.
        Optional<ShareCode> read = ShareCode.read(code, told);
        if (read.isPresent()) {
            assertThat(read).isEqualTo(ShareCode.read(code(), told));
        } else {
            assertThat(told.inOrder().get(0).message()).startsWith("is damaged");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"RIGIBO-LEVELS-AAAA", "RIGIBO-3-AAAA", "RIGIBO-"})
    void otherKindsAreOfAnotherVersion(String code) {
        assertThat(ShareCode.isMeantBy(code)).isTrue();
        assertThat(ShareCode.read(code, problems)).isEmpty();
        assertThat(problem()).startsWith("must begin with RIGIBO-LEVEL- or RIGIBO-REPLAY-");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", " ", "hello", "https://example.org/RIGIBO-LEVEL-AAAA", "{}"})
    void otherTextsAreNotMeant(String text) {
        assertThat(ShareCode.isMeantBy(text)).isFalse();
    }

    /** Letters at random cannot be packed to much less than 6.6 of their 8 bits. */
    @Test
    void whatIsTooLongHasNoCode() {
        SplittableRandom random = new SplittableRandom(1);
        JsonMapper json = JsonMapper.shared();
        JsonNode fits = json.createObjectNode().put("a", random(random, 1_500));
        JsonNode tooLong = json.createObjectNode().put("a", random(random, 2_000));
        assertThat(ShareCode.of(Kind.REPLAY, fits)).isPresent();
        assertThat(ShareCode.of(Kind.REPLAY, tooLong)).isEmpty();
        assertThat(ShareCode.read(START + "A".repeat(2_000), problems)).isEmpty();
        assertThat(problem()).isEqualTo("has 2,013 letters, and a code at most 2,000");
    }

    /** The densest packing makes 1,032 bytes of one. */
    @Test
    void whatUnpacksToMoreThanAFileMayHaveIsRefused() throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        packed.writeBytes(new byte[4]);
        Deflater raw = new Deflater(9, true);
        try (DeflaterOutputStream out = new DeflaterOutputStream(packed, raw)) {
            out.write(new byte[1_200_000]);
        }
        raw.end();
        String code =
                START
                        + Base64.getUrlEncoder()
                                .withoutPadding()
                                .encodeToString(packed.toByteArray());
        assertThat(code.length()).isLessThanOrEqualTo(ShareCode.MOST_LETTERS);
        assertThat(ShareCode.read(code, problems)).isEmpty();
        assertThat(problem()).startsWith("is larger than 1000000 bytes");
    }
}
