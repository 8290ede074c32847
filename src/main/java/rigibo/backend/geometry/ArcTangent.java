package rigibo.backend.geometry;

/**
 * The angle of a point (x, y), whose coordinates are each given as a high and a low part. It is
 * computed in the octant beside the x axis; other octants are mirrored to it. With t the tangent
 * and c the nearest of 0, ¼, ½, ¾ and 1, atan t = atan c + atan((t − c)/(1 + tc)). The second
 * tangent is at most 1/8. Its angle is a Taylor series, whose first omitted term is below 2⁻⁶⁶ of
 * the angle.
 */
final class ArcTangent {

    /** atan(c/4) for c from 0 to 4, as a high and a low part. */
    private static final double[] ARC_HIGH = {
        0, 0x1.f5b75f92c80ddp-3, 0x1.dac670561bb4fp-2, 0x1.4978fa3269ee1p-1, 0x1.921fb54442d18p-1
    };

    private static final double[] ARC_LOW = {
        0,
        0x1.8ab6e3cf7afbdp-57,
        0x1.a2b7f222f65e2p-56,
        0x1.2419a87f2a458p-56,
        0x1.1a62633145c07p-55
    };

    /** The low part of π: what the double lacks. */
    private static final double PI_LOW = 0x1.1a62633145c07p-53;

    /** Tangent below which the square of the angle is lost beside 1. */
    private static final double TINY = 0x1p-30;

    private ArcTangent() {}

    /**
     * Returns an angle in rad from 0 to π.
     *
     * @param y the high part, 0 or more; x and y are not both 0
     * @param yLow the low part of y
     * @param x the high part, of any sign, 0 counting as positive
     * @param xLow the low part of x
     */
    static double of(double y, double yLow, double x, double xLow) {
        double aside = Math.abs(x);
        double asideLow = x < 0 ? -xLow : xLow;
        boolean isSteep = y > aside;
        double small = isSteep ? aside : y;
        double smallLow = isSteep ? asideLow : yLow;
        double large = isSteep ? y : aside;
        double largeLow = isSteep ? yLow : asideLow;
        if (small < TINY * large) {
            return mirrored((small + smallLow) / large, 0, isSteep, x < 0);
        }
        int nearest = nearest(small, large);
        double c = 0.25 * nearest;
        double product = c * large;
        // The difference is exact, since the two are within a factor of two or the product is 0.
        double up = small - product;
        double upLow = smallLow - c * largeLow - Rounding.ofProduct(c, large, product);
        double along = large + c * small;
        double alongLow = largeLow + Rounding.ofSum(large, c * small, along);
        double t = up / along;
        double back = t * along;
        double rest = up - back - Rounding.ofProduct(t, along, back);
        double tLow = (rest + upLow - t * alongLow) / along;
        double bent = tLow + t * bend(t * t);
        double base = ARC_HIGH[nearest];
        double angle = base + t;
        double lost = nearest == 0 ? 0 : Rounding.ofSum(base, t, angle);
        return mirrored(angle, lost + (ARC_LOW[nearest] + bent), isSteep, x < 0);
    }

    /** Quarters next to small/large. */
    private static int nearest(double small, double large) {
        double eighths = 8 * small;
        if (eighths < 3 * large) {
            return eighths < large ? 0 : 1;
        }
        if (eighths < 5 * large) {
            return 2;
        }
        return eighths < 7 * large ? 3 : 4;
    }

    /** The Taylor series of atan(t)/t − 1 in z = t². */
    private static double bend(double z) {
        double zz = z * z;
        double odd = 1.0 / 3 + zz * (1.0 / 7 + zz * (1.0 / 11 + zz * (1.0 / 15 + zz / 19)));
        double even = 1.0 / 5 + zz * (1.0 / 9 + zz * (1.0 / 13 + zz / 17));
        return z * (z * even - odd);
    }

    private static double mirrored(double angle, double low, boolean isSteep, boolean isBehind) {
        if (!isSteep && !isBehind) {
            return angle + low;
        }
        double base = isSteep ? Math.PI / 2 : Math.PI;
        double baseLow = isSteep ? PI_LOW / 2 : PI_LOW;
        double side = isSteep == isBehind ? 1 : -1;
        double sum = base + side * angle;
        return sum + (Rounding.ofSum(base, side * angle, sum) + (baseLow + side * low));
    }
}
