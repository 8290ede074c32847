package rigibo.frontend.scene;

/**
 * Size and kind of a window or page, whatever it shows.
 *
 * @param width in pixels
 * @param height in pixels
 * @param contentScale pixels per pixel of text at its usual size
 * @param hidden the hidden parts of its edges, in pixels
 * @param isTouched whether it is used by fingers alone
 */
public record Pane(int width, int height, double contentScale, Edges hidden, boolean isTouched) {

    /**
     * Windows narrower than this are handheld, px of text: no phone is wider, and no desktop window
     * is made that small.
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
