package rigibo.lab.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

import javax.imageio.ImageIO;

class PngTest {

    private final Optional<PngLetters> letters = PngLetters.find();

    /** Else labels that keep apart by the one measure overlap in the picture. */
    @Test
    void lettersAreNoWiderThanThoseThatRoomIsMadeFor() {
        assumeTrue(letters.isPresent(), "this Java draws no letters");
        String words = "ABCDEFGHIJKLMNOPQRSTUVWXYZ abcdefghijklmnopqrstuvwxyz 0123456789 .,:/()=-";
        for (String letter : (words + "⁻⁰¹²³⁴⁵⁶⁷⁸⁹·×µ−–≤λΔ").split("")) {
            assertThat(letters.get().width(letter, 100))
                    .as("'%s'", letter)
                    .isLessThanOrEqualTo(Letters.width(letter, 100));
        }
    }

    @Test
    void surfaceIsWhereItWasDrawn(@TempDir Path directory) throws IOException {
        assumeTrue(letters.isPresent(), "this Java draws no letters");
        Png png = new Png(letters.get(), 100, 50);
        png.box(10, 30, 10, 20, Palette.BLUE);
        Path file = directory.resolve("box.png");
        png.write(file);
        BufferedImage image = ImageIO.read(file.toFile());
        assertThat(image.getWidth()).isEqualTo(200);
        assertThat(image.getHeight()).isEqualTo(100);
        assertThat(image.getRGB(40, 40) & 0xFFFFFF).isEqualTo(0x0072B2);
        assertThat(image.getRGB(70, 40) & 0xFFFFFF).isEqualTo(0xFFFFFF);
    }
}
