package rigibo.lab.bench;

/**
 * The exponent p of a time that grows as t = c·nᵖ with a size n, fitted by least squares on the
 * logarithms: p = Σ(x − x̄)(y − ȳ)/Σ(x − x̄)² with x = ln n, y = ln t.
 */
final class Growth {

    private Growth() {}

    /**
     * The exponent.
     *
     * @param sizes positive, two of them different at least
     * @param times positive, as many
     */
    static double exponent(double[] sizes, double[] times) {
        double meanX = 0;
        double meanY = 0;
        for (int i = 0; i < sizes.length; i++) {
            meanX += Math.log(sizes[i]) / sizes.length;
            meanY += Math.log(times[i]) / sizes.length;
        }
        double product = 0;
        double square = 0;
        for (int i = 0; i < sizes.length; i++) {
            double x = Math.log(sizes[i]) - meanX;
            product += x * (Math.log(times[i]) - meanY);
            square += x * x;
        }
        return product / square;
    }
}
