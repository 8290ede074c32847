package rigibo.lab.plot;

import java.util.ArrayList;
import java.util.List;

/** A picture of which the texts are remembered. */
public final class Seen implements Picture {

    /** Words and what they cover. */
    public record Text(String words, Box box) {}

    private final List<Text> texts = new ArrayList<>();

    public List<Text> texts() {
        return texts;
    }

    /** Pairs of texts that cover each other. */
    public List<String> overlaps() {
        List<String> pairs = new ArrayList<>();
        for (int i = 0; i < texts.size(); i++) {
            for (int j = 0; j < i; j++) {
                if (texts.get(i).box().overlaps(texts.get(j).box())) {
                    pairs.add(texts.get(i) + " over " + texts.get(j));
                }
            }
        }
        return pairs;
    }

    @Override
    public void text(double x, double y, Anchor anchor, int size, String color, String words) {
        texts.add(new Text(words, Box.of(x, y, anchor, size, words)));
    }

    @Override
    public void textOver(double x, double y, Anchor anchor, int size, String color, String words) {
        text(x, y, anchor, size, color, words);
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, String color) {}

    @Override
    public void dashed(double x1, double y1, double x2, double y2, String color) {}

    @Override
    public void path(List<Spot> spots, double width, String color) {}

    @Override
    public void box(double fromX, double toX, double y, double height, String color) {}

    @Override
    public void dot(double x, double y, double radius, String color) {}

    @Override
    public void polygon(List<Spot> corners, String color, double rimWidth, String rim) {}
}
