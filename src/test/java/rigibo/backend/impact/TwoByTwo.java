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

    TwoByTwo(Impact blow) {
        double mass = blow.inverseMassA + blow.inverseMassB;
        double ax = blow.armAX[0];
        double ay = blow.armAY[0];
        double bx = blow.armBX[0];
        double by = blow.armBY[0];
        double iA = blow.inverseInertiaA;
        double iB = blow.inverseInertiaB;
        a = mass + iA * ay * ay + iB * by * by;
        b = -iA * ax * ay - iB * bx * by;
        d = mass + iA * ax * ax + iB * bx * bx;
        solve(blow);
    }

    private void solve(Impact blow) {
        double nx = blow.normalX;
        double ny = blow.normalY;
        double vx = pointX(blow, 0) + blow.surfaceSpeed * ny;
        double vy = pointY(blow, 0) - blow.surfaceSpeed * nx;
        double closing = Math.max(0, -(vx * nx + vy * ny));
        double wanted = (1 + blow.elasticity) * closing;
        stick(-vx + blow.elasticity * closing * nx, -vy + blow.elasticity * closing * ny);
        double normal = x * nx + y * ny;
        double tangent = y * nx - x * ny;
        sticks = Math.abs(tangent) <= blow.friction * normal;
        if (!sticks) {
            slide(nx, ny, Math.copySign(blow.friction, tangent), wanted);
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
    static double pointX(Impact blow, int i) {
        return blow.velocityBX
                - blow.spinB * blow.armBY[i]
                - (blow.velocityAX - blow.spinA * blow.armAY[i]);
    }

    static double pointY(Impact blow, int i) {
        return blow.velocityBY
                + blow.spinB * blow.armBX[i]
                - (blow.velocityAY + blow.spinA * blow.armAX[i]);
    }
}
