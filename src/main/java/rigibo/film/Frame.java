package rigibo.film;

/**
 * One picture of a film.
 *
 * @param width px
 * @param height px
 * @param colors row by row from the top
 */
record Frame(int width, int height, int[] colors) {

    Frame {
        if (colors.length != width * height) {
            throw new IllegalArgumentException(
                    "Frame.colors must be " + width * height + ", were " + colors.length);
        }
    }

    /**
     * Half as wide and high: each pixel is the mean of four, which smooths what is drawn at twice
     * the size.
     */
    Frame halved() {
        int halfWidth = width / 2;
        int halfHeight = height / 2;
        int[] means = new int[halfWidth * halfHeight];
        for (int y = 0; y < halfHeight; y++) {
            for (int x = 0; x < halfWidth; x++) {
                int at = 2 * y * width + 2 * x;
                means[y * halfWidth + x] =
                        mean(
                                colors[at],
                                colors[at + 1],
                                colors[at + width],
                                colors[at + width + 1]);
            }
        }
        return new Frame(halfWidth, halfHeight, means);
    }

    private static int mean(int a, int b, int c, int d) {
        int mean = 0;
        for (int shift = 0; shift <= 16; shift += 8) {
            int sum =
                    (a >> shift & 0xff)
                            + (b >> shift & 0xff)
                            + (c >> shift & 0xff)
                            + (d >> shift & 0xff);
            mean |= (sum + 2) / 4 << shift;
        }
        return mean;
    }
}
