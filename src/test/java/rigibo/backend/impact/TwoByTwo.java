package rigibo.backend.impact;

/**
 * What one point's impact comes to, worked out in world coordinates: with [a b; b d] the velocity
 * that a unit impulse gives the point, and the impulse along (x, y) as the unknown.
 */
final class TwoByTwo {

    private final double a;
    private final double b;
    private final double d;

    /** The impulse on B, N·s. */
    double x;

    double y;

    /** Whether it sticks, and whether that or sliding would have added energy. */
    boolean sticks;

    boolean isScaled;

    TwoByTwo(Impact impact) {
        double mass = impact.inverseMassA + impact.inverseMassB;
        double ax = impact.armAX[0];
        double ay = impact.armAY[0];
        double bx = impact.armBX[0];
        double by = impact.armBY[0];
        double iA = impact.inverseInertiaA;
        double iB = impact.inverseInertiaB;
        a = mass + iA * ay * ay + iB * by * by;
        b = -iA * ax * ay - iB * bx * by;
        d = mass + iA * ax * ax + iB * bx * bx;
        solve(impact);
    }

    private void solve(Impact impact) {
        double nx = impact.normalX;
        double ny = impact.normalY;
        double vx = pointX(impact, 0) + impact.surfaceSpeed * ny;
        double vy = pointY(impact, 0) - impact.surfaceSpeed * nx;
        double closing = Math.max(0, -(vx * nx + vy * ny));
        double wanted = (1 + impact.elasticity) * closing;
        stick(-vx + impact.elasticity * closing * nx, -vy + impact.elasticity * closing * ny);
        double normal = x * nx + y * ny;
        double tangent = y * nx - x * ny;
        sticks = Math.abs(tangent) <= impact.friction * normal;
        if (!sticks) {
            slide(nx, ny, Math.copySign(impact.friction, tangent), wanted);
        }
        keepEnergy(vx, vy);
    }

    private void stick(double wantedX, double wantedY) {
        double determinant = a * d - b * b;
        x = (d * wantedX - b * wantedY) / determinant;
        y = (a * wantedY - b * wantedX) / determinant;
    }

    /** Along n + slope·t. */
    private void slide(double nx, double ny, double slope, double wanted) {
        double alongX = nx - slope * ny;
        double alongY = ny + slope * nx;
        double normal = wanted / response(nx, ny, alongX, alongY);
        x = normal * alongX;
        y = normal * alongY;
    }

    private double response(double alongX, double alongY, double ofX, double ofY) {
        return alongX * (a * ofX + b * ofY) + alongY * (b * ofX + d * ofY);
    }

    private void keepEnergy(double vx, double vy) {
        double linear = x * vx + y * vy;
        double quadratic = response(x, y, x, y);
        isScaled = linear + quadratic / 2 > 0;
        if (isScaled) {
            double scale = Math.max(0, -2 * linear / quadratic);
            x *= scale;
            y *= scale;
        }
    }

    /** Velocity of B's point seen from A's, m/s. */
    static double pointX(Impact impact, int i) {
        return impact.velocityBX
                - impact.spinB * impact.armBY[i]
                - (impact.velocityAX - impact.spinA * impact.armAY[i]);
    }

    static double pointY(Impact impact, int i) {
        return impact.velocityBY
                + impact.spinB * impact.armBX[i]
                - (impact.velocityAY + impact.spinA * impact.armAX[i]);
    }
}
