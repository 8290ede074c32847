package rigibo.film;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.NodeList;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;

/** The JDK's reader reads back every file that is written. */
class GifFileTest {

    private static final int WIDTH = 40;
    private static final int HEIGHT = 30;
    private static final int GROUND = 0x2A2E4C;
    private static final int BALL = 0xF4F1E6;

    @TempDir Path folder;

    /** A ball of one pixel on a ground. */
    private static Frame frame(int x, int y) {
        int[] colors = new int[WIDTH * HEIGHT];
        Arrays.fill(colors, GROUND);
        colors[y * WIDTH + x] = BALL;
        return new Frame(WIDTH, HEIGHT, colors);
    }

    private List<Frame> written(Frame... frames) throws IOException {
        Path file = folder.resolve("a.gif");
        try (GifFile gif = new GifFile(file, Palette.of(List.of(frames)))) {
            for (Frame frame : frames) {
                gif.add(frame, 5);
            }
        }
        return read(file);
    }

    /** The frames as a viewer shows them, each drawn over the one before. */
    private static List<Frame> read(Path file) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        BufferedImage screen = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        List<Frame> frames = new ArrayList<>();
        try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
            reader.setInput(in);
            for (int i = 0; i < reader.getNumImages(true); i++) {
                IIOMetadataNode tree =
                        (IIOMetadataNode)
                                reader.getImageMetadata(i).getAsTree("javax_imageio_gif_image_1.0");
                NodeList places = tree.getElementsByTagName("ImageDescriptor");
                IIOMetadataNode place = (IIOMetadataNode) places.item(0);
                int x = Integer.parseInt(place.getAttribute("imageLeftPosition"));
                int y = Integer.parseInt(place.getAttribute("imageTopPosition"));
                screen.getGraphics().drawImage(reader.read(i), x, y, null);
                int[] colors = screen.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
                for (int at = 0; at < colors.length; at++) {
                    colors[at] &= 0xffffff;
                }
                frames.add(new Frame(WIDTH, HEIGHT, colors));
            }
        } finally {
            reader.dispose();
        }
        return frames;
    }

    @Test
    void everyFrameIsSeenAsItWasThoughOnlyChangesAreWritten() throws IOException {
        Frame[] frames = {frame(3, 4), frame(20, 10), frame(20, 10), frame(39, 29)};
        List<Frame> seen = written(frames);
        assertThat(seen).hasSize(frames.length);
        for (int i = 0; i < frames.length; i++) {
            for (int at = 0; at < WIDTH * HEIGHT; at++) {
                assertNear(seen.get(i).colors()[at], frames[i].colors()[at]);
            }
        }
    }

    /** A channel is kept to half a bin, which is one level of 128. */
    private static void assertNear(int seen, int color) {
        for (int shift = 0; shift <= 16; shift += 8) {
            int apart = (seen >> shift & 0xff) - (color >> shift & 0xff);
            assertThat(Math.abs(apart)).as("%06x for %06x", seen, color).isLessThanOrEqualTo(1);
        }
    }

    @Test
    void itLoopsForEver() throws IOException {
        written(frame(1, 1), frame(2, 2));
        String bytes = Files.readString(folder.resolve("a.gif"), StandardCharsets.ISO_8859_1);
        assertThat(bytes).startsWith("GIF89a").contains("NETSCAPE2.0\u0003\u0001\u0000\u0000");
    }

    @Test
    void halvingTakesTheMeanOfFour() {
        Frame frame = new Frame(2, 2, new int[] {0x000000, 0x040000, 0x000800, 0x00000C});
        assertThat(frame.halved().colors()).containsExactly(0x010203);
    }

    @Test
    void aPaletteHasAColourForWhatIsSmallBesideALargeGround() {
        int[] colors = new int[256 * 256];
        for (int i = 0; i < colors.length; i++) {
            colors[i] = i % 256 << 16 | i / 256 << 8;
        }
        for (int i = 0; i < 16; i++) {
            colors[i] = 0x3FC1A9;
        }
        Frame frame = new Frame(256, 256, colors);
        Palette palette = Palette.of(List.of(frame));
        int nearest = palette.model().getRGB(palette.entry(0x3FC1A9)) & 0xffffff;
        assertNear(nearest, 0x3FC1A9);
    }
}
