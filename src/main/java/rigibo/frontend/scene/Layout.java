package rigibo.frontend.scene;

import java.util.function.Function;

/**
 * The part of the plane that a window shows, in logical pixels. A scene lies at (0, 0) and measures
 * {@link Scene#WIDTH} × {@link Scene#HEIGHT}; a window of another shape shows more on its sides, so
 * that points left of the scene have a negative x. A layout makes a scene as large as fits and
 * never distorts it; the scene's own coordinates stay the same.
 *
 * @param left x of the window's left edge, 0 or less
 * @param top y of its upper edge, 0 or less
 * @param width of the window, {@link Scene#WIDTH} or more
 * @param height of the window, {@link Scene#HEIGHT} or more
 * @param ratio pixels of the window per logical one
 * @param type factor by which the smallest text is enlarged to be read in a small window, 1 or more
 * @param touch what a handheld window needs for fingers
 */
public record Layout(
        double left,
        double top,
        double width,
        double height,
        double ratio,
        double type,
        Touch touch) {

    /** Smallest share of its usual size at which a scene is still to be read. */
    public static final double LEAST_SCALE = 0.85;

    /** Width of a column of plates with text of its usual size, px. */
    private static final double COLUMN = 270;

    /** Gap between a column and the scene beside it, px. */
    private static final double GAP = 5;

    /** Wider than this a column of plates is hard to read, px. */
    private static final double WIDEST_COLUMN = 330;

    /** Factor by which the smallest text of most scenes can be enlarged. */
    static final double MOST_TYPE = 1.3;

    /** The smallest text of scenes, px. */
    private static final double SMALLEST_TEXT = 16;

    /** The smallest text of a handheld window, px of its screen. */
    private static final double TEXT_IN_HAND = 14;

    /** Smallest side of anything to touch, px of the screen. */
    public static final double FINGER = 44;

    /** A scene in a window of its own shape and size. */
    public static final Layout ALONE = of(Scene.WIDTH, Scene.HEIGHT, 1);

    /** A layout for a desktop window. */
    Layout(double left, double top, double width, double height, double ratio, double type) {
        this(left, top, width, height, ratio, type, Touch.NONE);
    }

    /**
     * A scene in the middle of a window.
     *
     * @param windowWidth in pixels
     * @param windowHeight in pixels
     * @param contentScale pixels of the window per pixel of text at its usual size: 2 on a screen
     *     whose pixels are half as large as usual
     */
    public static Layout of(int windowWidth, int windowHeight, double contentScale) {
        double ratio =
                Math.min(
                        Math.max(1, windowWidth) / (double) Scene.WIDTH,
                        Math.max(1, windowHeight) / (double) Scene.HEIGHT);
        double width = Math.max(Scene.WIDTH, windowWidth / ratio);
        double height = Math.max(Scene.HEIGHT, windowHeight / ratio);
        double type = Math.max(1, Math.min(1 / LEAST_SCALE, contentScale / ratio));
        return new Layout(
                (Scene.WIDTH - width) / 2, (Scene.HEIGHT - height) / 2, width, height, ratio, type);
    }

    /**
     * A scene in the middle of a handheld window.
     *
     * @param windowWidth in pixels
     * @param windowHeight in pixels
     * @param contentScale pixels of the window per pixel of text at its usual size
     * @param hidden the hidden parts of the window's edges, in pixels
     */
    public static Layout inHand(
            int windowWidth, int windowHeight, double contentScale, Edges hidden) {
        Layout plain = of(windowWidth, windowHeight, contentScale);
        double unit = contentScale / plain.ratio;
        return new Layout(
                plain.left,
                plain.top,
                plain.width,
                plain.height,
                plain.ratio,
                Math.max(1, TEXT_IN_HAND * unit / SMALLEST_TEXT),
                new Touch(FINGER * unit, hidden.times(1 / plain.ratio)));
    }

    /**
     * Returns a layout with larger text.
     *
     * @param share of the usual size, 1 or more
     * @param most factor that there is room for, together with that of a small window
     */
    public Layout withText(double share, double most) {
        double larger = Math.max(type, Math.min(most, type * share));
        return new Layout(left, top, width, height, ratio, larger, touch);
    }

    /**
     * Returns a layout with room for plates beside the scene: moves the scene to the right edge
     * where there is room for one column, and none for two. In a handheld window it stays in the
     * middle.
     */
    public Layout withColumns() {
        double beside = width - Scene.WIDTH;
        boolean isForOne = !isInHand() && beside >= margin() && beside < 2 * margin();
        return isForOne ? new Layout(-beside, top, width, height, ratio, type, touch) : this;
    }

    /**
     * Returns a layout with all the room at one side of the scene, where a text fits into it; with
     * room for plates where none does.
     */
    public Layout withSource() {
        double beside = width - Scene.WIDTH;
        return !isInHand() && beside >= 2 * margin()
                ? new Layout(-beside, top, width, height, ratio, type, touch)
                : withColumns();
    }

    /** Whether there is room for a text at the left of the scene. */
    public boolean hasSource() {
        return !isInHand() && -left >= 2 * margin();
    }

    /** Width of a text at the left of the scene, px; it begins at a gap from the window's edge. */
    public double sourceWidth() {
        return -left - 2 * GAP;
    }

    /** Left edge of a text at the left of the scene, px. */
    public double sourceLeft() {
        return left + GAP;
    }

    /** Least width beside the scene for a column, px. */
    private double margin() {
        return COLUMN * type + 2 * GAP;
    }

    /** How many columns of plates there is room for beside the scene: 0, 1 (left) or 2. */
    public int columns() {
        return (-left >= margin() ? 1 : 0) + (right() - Scene.WIDTH >= margin() ? 1 : 0);
    }

    /** Width of a column beside the scene, px. */
    public double columnWidth() {
        return Math.min(Math.max(WIDEST_COLUMN, COLUMN * type), -left - 2 * GAP);
    }

    /** Left edge of the column on the left, next to the scene, px. */
    public double leftColumn() {
        return -GAP - columnWidth();
    }

    /** Left edge of the column on the right, next to the scene, px. */
    public double rightColumn() {
        return Scene.WIDTH + GAP;
    }

    /** Right edge of the window, px. */
    public double right() {
        return left + width;
    }

    /** Lower edge of the window, px. */
    public double bottom() {
        return top + height;
    }

    /** Whether fingers are used and there is little room. */
    public boolean isInHand() {
        return touch.least() > 0;
    }

    /** Whether it is higher than wide, so that buttons lie above and below the scene. */
    public boolean isUpright() {
        return height > width;
    }

    /**
     * One of three ways to lay something out.
     *
     * @param onADesk used for a desktop window
     * @param upright makes the layout of a handheld window that is higher than wide
     * @param lying makes the layout of any other handheld window
     */
    public <P> P choose(P onADesk, Function<Layout, P> upright, Function<Layout, P> lying) {
        if (!isInHand()) {
            return onADesk;
        }
        return isUpright() ? upright.apply(this) : lying.apply(this);
    }

    /** Left edge of the visible part of the window, px. */
    public double seenLeft() {
        return left + touch.hidden().left();
    }

    /** Upper edge of the visible part of the window, px. */
    public double seenTop() {
        return top + touch.hidden().top();
    }

    /** Right edge of the visible part of the window, px. */
    public double seenRight() {
        return right() - touch.hidden().right();
    }

    /** Lower edge of the visible part of the window, px. */
    public double seenBottom() {
        return bottom() - touch.hidden().bottom();
    }

    /**
     * The window as a sheet, from its upper left corner on, in px of which a small letter has 16 in
     * any window. It is for parts laid out in the window instead of around the scene.
     */
    public Layout sheet() {
        return new Layout(
                0,
                0,
                width / type,
                height / type,
                ratio * type,
                1,
                new Touch(touch.least() / type, touch.hidden().times(1 / type)));
    }

    /** Height of something to click, px: in a handheld window, at least that of a finger. */
    public double clickable(double usual) {
        return Math.max(usual, touch.least());
    }

    /**
     * A length that grows with small text in a handheld window, px; unchanged in a desktop window.
     */
    public double lettered(double usual) {
        return isInHand() ? usual * type : usual;
    }

    /** Whether something round about a point can be seen in the window, px. */
    public boolean shows(double x, double y, double radius) {
        return x > left - radius
                && x < right() + radius
                && y > top - radius
                && y < bottom() + radius;
    }

    /** Converts an x in pixels of the window to logical px. */
    public double logicalX(double windowX) {
        return left + windowX / ratio;
    }

    /** Converts a y in pixels of the window to logical px. */
    public double logicalY(double windowY) {
        return top + windowY / ratio;
    }

    /** Converts a logical x to pixels of the window. */
    public double windowX(double logicalX) {
        return (logicalX - left) * ratio;
    }

    /** Converts a logical y to pixels of the window. */
    public double windowY(double logicalY) {
        return (logicalY - top) * ratio;
    }

    /** The size at which a text is drawn that is meant to be of a size, px. */
    public double textSize(double size) {
        return Math.max(size, SMALLEST_TEXT * type);
    }
}
