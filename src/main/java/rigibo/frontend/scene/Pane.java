package rigibo.frontend.scene;

/**
 * What a window or a page is, whatever it shows.
 *
 * @param width in pixels
 * @param height in pixels
 * @param contentScale pixels per pixel of text at its usual size
 * @param hidden what is not seen of its edges, in pixels
 * @param isTouched whether fingers are all that points at it
 */
public record Pane(int width, int height, double contentScale, Edges hidden, boolean isTouched) {

    /**
     * Smaller windows are held in a hand, px of text: no phone is wider, and no window on a desk is
     * made as small.
     */
    private static final double SMALLEST_ON_A_DESK = 500;

    /** The layout of a scene, with small text by a share of its usual size. */
    public Layout layout(Scene scene, double text) {
        Layout plain =
                isInHand() && scene.isForHands()
                        ? Layout.inHand(width, height, contentScale, hidden)
                        : Layout.of(width, height, contentScale);
        Layout lettered = plain.withText(text, scene.mostType());
        if (lettered.isInHand() && scene.isSheet()) {
            return lettered.sheet();
        }
        if (scene.hasSource()) {
            return lettered.withSource();
        }
        return scene.hasColumns() ? lettered.withColumns() : lettered;
    }

    /** Whether it is as small as a phone, or has neither a mouse nor, as a rule, keys. */
    public boolean isInHand() {
        return isTouched || Math.min(width, height) < SMALLEST_ON_A_DESK * contentScale;
    }
}
