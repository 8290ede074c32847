package rigibo.frontend.scene;

/**
 * Converts between the world, in metres with y up, and the screen, in logical pixels with y down.
 */
public final class Camera {

    /** Pixels per metre at which 9 × 10 m fill the window. */
    public static final double DEFAULT_SCALE = 80;

    private static final double LEAST_SCALE = 2;
    private static final double MOST_SCALE = 800;

    private double homeX;
    private double homeY;
    private double homeScale;
    private double centreX;
    private double centreY;
    private double scale;

    /** Whether two fingers changed the view since it was last set. */
    private boolean isPinched;

    /**
     * A camera that looks at a point.
     *
     * @param centreX world x in the middle of the window, m
     * @param centreY world y in the middle of the window, m
     * @param scale pixels per metre
     */
    public Camera(double centreX, double centreY, double scale) {
        homeX = centreX;
        homeY = centreY;
        homeScale = scale;
        home();
    }

    /** The camera of the puzzle: origin in the lower left corner. */
    public static Camera ofPuzzle() {
        return new Camera(
                Scene.WIDTH / 2 / DEFAULT_SCALE, Scene.HEIGHT / 2 / DEFAULT_SCALE, DEFAULT_SCALE);
    }

    /** Begins anew with the initial view of another camera. */
    public void begin(Camera other) {
        homeX = other.homeX;
        homeY = other.homeY;
        homeScale = other.homeScale;
        home();
    }

    /** World x in the middle of the initial view, m. */
    public double homeX() {
        return homeX;
    }

    /** Returns to the initial view. */
    public void home() {
        look(homeX, homeY, homeScale);
    }

    /** Looks elsewhere: world m in the middle of the window, pixels per metre. */
    public void look(double worldX, double worldY, double pixelsPerMetre) {
        centreX = worldX;
        centreY = worldY;
        scale = pixelsPerMetre;
        isPinched = false;
    }

    /** Zooms by a factor about a point of the screen, px. */
    public void zoom(double factor, double screenX, double screenY) {
        double worldX = worldX(screenX);
        double worldY = worldY(screenY);
        scale = Math.max(LEAST_SCALE, Math.min(MOST_SCALE, scale * factor));
        centreX += worldX - worldX(screenX);
        centreY += worldY - worldY(screenY);
    }

    /** Moves the view by a distance on the screen, px. */
    public void pan(double screenDx, double screenDy) {
        centreX -= screenDx / scale;
        centreY += screenDy / scale;
    }

    /** The point between two fingers stays between them. */
    public void pinch(Pinch pinch) {
        pan(pinch.dx(), pinch.dy());
        zoom(pinch.factor(), pinch.x(), pinch.y());
        isPinched = true;
    }

    /** Whether two fingers changed the view since it was last set. */
    public boolean isPinched() {
        return isPinched;
    }

    /** Pixels per metre. */
    public double scale() {
        return scale;
    }

    /** Screen x in px of a world x in m. */
    public double screenX(double worldX) {
        return Scene.WIDTH / 2.0 + (worldX - centreX) * scale;
    }

    /** Screen y in px of a world y in m. */
    public double screenY(double worldY) {
        return Scene.HEIGHT / 2.0 - (worldY - centreY) * scale;
    }

    /** World x in m of a screen x in px. */
    public double worldX(double screenX) {
        return centreX + (screenX - Scene.WIDTH / 2.0) / scale;
    }

    /** World y in m of a screen y in px. */
    public double worldY(double screenY) {
        return centreY - (screenY - Scene.HEIGHT / 2.0) / scale;
    }
}
