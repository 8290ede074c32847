package rigibo.fuzz.program;

import rigibo.fuzz.chance.Chance;

/**
 * How a program draws its numbers: bodies of similar size close to each other, which meet, unlike
 * bodies drawn at random places.
 *
 * @param size of its bodies, m
 * @param reach of its scene about the middle, m
 * @param middleX of the scene, m
 * @param middleY of the scene, m
 * @param speed of its bodies, m/s
 * @param wildness how likely a number is of a quite different size
 */
record Temper(
        double size, double reach, double middleX, double middleY, double speed, double wildness) {

    /** The sizes of the smallest and the largest body, m. */
    static final double SMALLEST = 1e-4;

    static final double GREATEST = 1e4;

    /** The size is usually that of a game's bodies, and otherwise any. */
    static Temper draw(Chance chance, int bodies) {
        double size = chance.happens(0.5) ? 0.5 : chance.ofAnySize(SMALLEST, GREATEST);
        double crowding = chance.oneOf(0.5, 1.0, 2.0, 4.0);
        double far = chance.happens(0.1) ? chance.ofEitherSign(1, 1e12) : 0;
        return new Temper(
                size,
                crowding * size * Math.sqrt(bodies + 1),
                far,
                chance.happens(0.5) ? far : 0,
                size * chance.ofAnySize(0.1, 30),
                chance.oneOf(0.0, 0.0, 0.002, 0.02, 0.1));
    }

    private boolean isWild(Chance chance) {
        return chance.happens(wildness);
    }

    double length(Chance chance) {
        return isWild(chance)
                ? chance.ofAnySize(SMALLEST, GREATEST)
                : size * chance.ofAnySize(0.3, 3);
    }

    double placeX(Chance chance) {
        return isWild(chance) ? far(chance) : middleX + reach * chance.between(-1, 1);
    }

    double placeY(Chance chance) {
        return isWild(chance) ? far(chance) : middleY + reach * chance.between(-1, 1);
    }

    /** A place that may be anywhere. */
    private static double far(Chance chance) {
        return chance.ofEitherSign(1e-12, chance.oneOf(1e3, 1e9, 1e18, 1e160, 1e308));
    }

    double angle(Chance chance) {
        return chance.happens(0.3) ? 0 : chance.between(-4, 4) * (isWild(chance) ? 1e6 : 1);
    }

    double velocity(Chance chance) {
        if (isWild(chance)) {
            return chance.ofEitherSign(1e-9, 299_792_458);
        }
        return chance.happens(0.3) ? 0 : speed * chance.between(-1, 1);
    }

    double spin(Chance chance) {
        if (isWild(chance)) {
            return chance.ofEitherSign(1e-9, 1e6);
        }
        return chance.happens(0.3) ? 0 : speed / size * chance.between(-1, 1);
    }

    /** A number that is usually about one. */
    double factor(Chance chance, double most) {
        return isWild(chance) ? chance.ofAnySize(1 / most, most) : chance.ofAnySize(0.1, 10);
    }
}
