package rigibo.frontend.draw;

/**
 * How eyes and mouth are placed on a body, in units of the face; in the order of the shader that
 * bakes the faces. On thin boxes a usual face would be too small to be read.
 */
enum FaceForm {
    /** The mouth under the eyes. */
    USUAL(0.36, 0.14, 0.7),
    /** For low boxes: the mouth between the eyes. */
    LOW(0.62, 0, 1.1),
    /** For narrow boxes: eyes side by side. */
    NARROW(0.245, 0.27, 0.7);

    /** Largest unit of a face, m, and of one whose eyes are side by side. */
    private static final double MOST = 0.46;

    private static final double MOST_NARROW = 0.34;

    /** A usual face's unit is half a square body's side, and a little more for long bodies. */
    private static final double OF_WIDTH = 1.2;

    private static final double OF_HEIGHT = 1.9;

    /** Room that eyes need from the middle to the side, with a margin, in units. */
    private static final double EYE = 0.32;

    private static final double EYES = 0.55;

    /** Sides from which on a box is narrow. */
    private static final double SLENDER = 2;

    /** Place of the right eye. */
    final double eyeX;

    final double eyeY;

    /** Half the width of the sheet about a face's middle. */
    final double reach;

    FaceForm(double eyeX, double eyeY, double reach) {
        this.eyeX = eyeX;
        this.eyeY = eyeY;
        this.reach = reach;
    }

    /** The form with which the face of a body is largest. */
    static FaceForm of(Figure figure) {
        if (!figure.isBox) {
            return USUAL;
        }
        if (figure.halfHeight >= SLENDER * figure.halfWidth) {
            return NARROW;
        }
        return LOW.unit(figure) > USUAL.unit(figure) ? LOW : USUAL;
    }

    /** The unit of the face on a body, m. */
    double unit(Figure figure) {
        double wide = figure.halfWidth;
        double high = figure.halfHeight;
        return switch (this) {
            case USUAL -> Math.min(MOST, Math.min(OF_WIDTH * wide, OF_HEIGHT * high));
            case LOW -> Math.min(MOST, Math.min(wide / reach, high / EYE));
            case NARROW -> Math.min(MOST_NARROW, Math.min(wide / EYES, high / reach));
        };
    }
}
