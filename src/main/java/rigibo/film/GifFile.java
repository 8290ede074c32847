package rigibo.film;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.nio.file.Path;

import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOInvalidTreeException;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

/**
 * A GIF file that plays for ever (W3C, GIF89a specification; the extension that makes it loop is
 * Netscape's). Of each frame only the rectangle that differs from the previous frame is written;
 * within it, equal pixels are transparent.
 */
final class GifFile implements AutoCloseable {

    private static final String STREAM_TREE = "javax_imageio_gif_stream_1.0";
    private static final String TREE = "javax_imageio_gif_image_1.0";

    private final Palette palette;
    private final IndexColorModel model;
    private final ImageOutputStream out;
    private final ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
    private byte[] before = {};

    GifFile(Path file, Palette palette) throws IOException {
        this.palette = palette;
        model = palette.model();
        out = ImageIO.createImageOutputStream(file.toFile());
        if (out == null) {
            throw new IOException("cannot write " + file);
        }
        writer.setOutput(out);
        writer.prepareWriteSequence(stream());
    }

    /** The colours, once for all frames: without them the writer would take some of its own. */
    private IIOMetadata stream() throws IIOInvalidTreeException {
        IIOMetadataNode root = new IIOMetadataNode(STREAM_TREE);
        IIOMetadataNode table = child(root, "GlobalColorTable");
        table.setAttribute("sizeOfGlobalColorTable", Integer.toString(model.getMapSize()));
        table.setAttribute("backgroundColorIndex", "0");
        table.setAttribute("sortFlag", "FALSE");
        for (int i = 0; i < model.getMapSize(); i++) {
            IIOMetadataNode entry = child(table, "ColorTableEntry");
            entry.setAttribute("index", Integer.toString(i));
            entry.setAttribute("red", Integer.toString(model.getRed(i)));
            entry.setAttribute("green", Integer.toString(model.getGreen(i)));
            entry.setAttribute("blue", Integer.toString(model.getBlue(i)));
        }
        IIOMetadata metadata = writer.getDefaultStreamMetadata(null);
        metadata.mergeTree(STREAM_TREE, root);
        return metadata;
    }

    /** Adds a frame that is shown for a number of hundredths of a second. */
    void add(Frame frame, int hundredths) throws IOException {
        byte[] entries = new byte[frame.colors().length];
        for (int i = 0; i < entries.length; i++) {
            entries[i] = (byte) palette.entry(frame.colors()[i]);
        }
        boolean isFirst = before.length == 0;
        Rectangle changed =
                isFirst
                        ? new Rectangle(frame.width(), frame.height())
                        : changed(entries, frame.width());
        BufferedImage image = image(entries, frame.width(), changed);
        writer.writeToSequence(
                new IIOImage(image, null, metadata(image, changed, hundredths, isFirst)), null);
        before = entries;
    }

    /** The smallest rectangle with all that differs; of one pixel where nothing does. */
    private Rectangle changed(byte[] entries, int width) {
        Rectangle changed = new Rectangle(-1, -1);
        for (int i = 0; i < entries.length; i++) {
            if (entries[i] != before[i]) {
                changed.add(new Rectangle(i % width, i / width, 1, 1));
            }
        }
        return changed.isEmpty() ? new Rectangle(1, 1) : changed;
    }

    private BufferedImage image(byte[] entries, int width, Rectangle part) {
        BufferedImage image =
                new BufferedImage(part.width, part.height, BufferedImage.TYPE_BYTE_INDEXED, model);
        byte[] row = new byte[part.width];
        for (int y = 0; y < part.height; y++) {
            for (int x = 0; x < part.width; x++) {
                int at = (part.y + y) * width + part.x + x;
                boolean isSame = before.length > 0 && entries[at] == before[at];
                row[x] = isSame ? (byte) Palette.UNCHANGED : entries[at];
            }
            image.getRaster().setDataElements(0, y, part.width, 1, row);
        }
        return image;
    }

    private IIOMetadata metadata(
            BufferedImage image, Rectangle part, int hundredths, boolean isFirst)
            throws IIOInvalidTreeException {
        // Not createFromRenderedImage: that answers with the library's own colours for all indexed.
        IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(image), null);
        IIOMetadataNode root = new IIOMetadataNode(TREE);
        IIOMetadataNode place = child(root, "ImageDescriptor");
        place.setAttribute("imageLeftPosition", Integer.toString(part.x));
        place.setAttribute("imageTopPosition", Integer.toString(part.y));
        place.setAttribute("imageWidth", Integer.toString(part.width));
        place.setAttribute("imageHeight", Integer.toString(part.height));
        place.setAttribute("interlaceFlag", "FALSE");
        IIOMetadataNode control = child(root, "GraphicControlExtension");
        control.setAttribute("disposalMethod", "doNotDispose");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", "TRUE");
        control.setAttribute("delayTime", Integer.toString(hundredths));
        control.setAttribute("transparentColorIndex", Integer.toString(Palette.UNCHANGED));
        if (isFirst) {
            IIOMetadataNode loop =
                    child(child(root, "ApplicationExtensions"), "ApplicationExtension");
            loop.setAttribute("applicationID", "NETSCAPE");
            loop.setAttribute("authenticationCode", "2.0");
            // A sub-block that begins with 1 tells how often; 0 is for ever.
            loop.setUserObject(new byte[] {1, 0, 0});
        }
        metadata.mergeTree(TREE, root);
        return metadata;
    }

    private static IIOMetadataNode child(IIOMetadataNode parent, String name) {
        IIOMetadataNode child = new IIOMetadataNode(name);
        parent.appendChild(child);
        return child;
    }

    @Override
    public void close() throws IOException {
        writer.endWriteSequence();
        out.close();
        writer.dispose();
    }
}
